/// An attempt again: the bone and the saw at each moment, the timeline, and what people say about
/// moments of it.
#pragma once

#include <memory>
#include <optional>

#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/message_form.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/pictures/bone_viewport.h"
#include "ui/screens/replay/blade_inset.h"
#include "ui/screens/replay/made_replays.h"
#include "ui/screens/replay/notes_panel.h"
#include "ui/screens/replay/pinned_places.h"
#include "ui/screens/replay/player.h"
#include "ui/screens/replay/replay_material.h"
#include "ui/screens/replay/replay_timeline.h"
#include "ui/widgets/controls/row_table.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class ReplayScreen : public Screen {
 public:
  ReplayScreen(std::shared_ptr<SignedInSession> signed_in, database::AttemptId attempt,
               double moment_s)
      : signed_in_(std::move(signed_in)), attempt_(std::move(attempt)), first_moment_s_(moment_s) {
    notes_.emplace(signed_in_, attempt_);
  }
  /// A simulated hand at that operation. It is nobody's attempt, so nothing is said about its
  /// moments.
  ReplayScreen(std::shared_ptr<SignedInSession> signed_in, std::shared_ptr<MadeReplays> made,
               scenarios::Scenario scenario)
      : signed_in_(std::move(signed_in)),
        made_(std::move(made)),
        made_of_(std::move(scenario)),
        tab_(events_tab) {}

  GuideSection guide_section() const override { return GuideSection::Replay; }
  WindowChrome surround() const override { return WindowChrome::Rail; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  static constexpr int notes_tab = 0, ledger_tab = 1, events_tab = 2;

  bool is_made() const noexcept { return made_ != nullptr; }
  void start(Ui& ui, Shell& shell);
  /// What stands there until there is something to show.
  bool draw_until_ready(Ui& ui, const Rect& content, Shell& shell);
  std::string crumb(const Ui& ui) const;
  const ReplayMaterial& material() const { return *material_.value(); }
  void open(Ui& ui);
  void draw_replay(Ui& ui, const Rect& content, Shell& shell);
  void draw_head(Ui& ui, const Rect& bar, Shell& shell);
  void draw_view(Ui& ui, const Rect& rect, Shell& shell);
  void draw_view_choices(Ui& ui, const Rect& rect, bool has_section);
  /// Shows what was on the screen at this moment, where that is chosen.
  bool shows_section(const Rect& rect, const HandAtMoment& hand) const;
  void look_as_seen(const Rect& rect);
  void draw_seen(Ui& ui, const Rect& rect, float until_x) const;
  void draw_pins(Ui& ui);
  Scene scene_of(const Ui& ui, const HandAtMoment& hand) const;
  void pick(const SightRay& ray);
  void draw_panel(Ui& ui, const Rect& rect, Shell& shell);
  void draw_ledger(Ui& ui, const Rect& rect);
  void draw_events(Ui& ui, const Rect& rect);
  /// The height that the timeline takes, and with it the legend.
  float time_height(const Ui& ui, const Timeline& shown, float width) const;
  void draw_time(Ui& ui, const Rect& rect, const Timeline& shown);
  void hear_timeline(const TimelineAnswer& answer);
  void hear_keys(Ui& ui);
  void draw_forms(Ui& ui, Shell& shell);
  database::AttemptMoment moment_now() const;
  const Remarks& remarks() const noexcept { return notes_ ? notes_->remarks() : no_remarks_; }

  std::shared_ptr<SignedInSession> signed_in_;
  database::AttemptId attempt_;
  double first_moment_s_ = 0.0;
  /// Where a simulated hand is shown; attempt_ is none then.
  std::shared_ptr<MadeReplays> made_;
  scenarios::Scenario made_of_;
  Loaded<std::shared_ptr<const ReplayMaterial>> material_;
  /// Of the material.
  std::unique_ptr<simulator::BoneMoment> bone_;
  BoneViewport stage_;
  BladeInset inset_;
  Player player_;
  ReplayTimeline timeline_;
  /// Of a stored attempt.
  std::optional<NotesPanel> notes_;
  const Remarks no_remarks_;
  MessageForm ask_, pin_;
  TableState ledger_, events_;
  PinnedPlaces places_;
  std::optional<simulator::PlaceOnFragment> picked_;
  int tab_ = notes_tab;
  /// Of the views, 0 as it was seen; none once somebody has turned it.
  int view_ = 0;
  bool shows_plan_ = true;
};

}  // namespace hallux::ui
