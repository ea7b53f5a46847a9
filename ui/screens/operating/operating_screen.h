/// The screen of an operation: the view of a session, with keys, picture, panels and cards.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/screens/operating/operating_session.h"
#include "ui/screens/operating/operating_viewport.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/sound/saw_player.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

/// What somebody chose to operate.
struct OperationChoice {
  database::ScenarioVersionId scenario;
  database::AttemptKind kind = database::AttemptKind::Practice;
  simulator::Guidance guidance = simulator::Guidance::None;
};

/// Lends a device whose hand holds the saw in that pose.
/// thread  any but the window's
using LendDevice = std::function<std::unique_ptr<simulator::SteeredDevice>(
    const RigidTransform& world_from_start)>;

class OperatingScreen : public Screen {
 public:
  OperatingScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
                  const OperationChoice& choice, LendDevice lend_device);

  GuideSection guide_section() const override { return GuideSection::Operate; }
  WindowChrome surround() const override { return WindowChrome::Badge; }
  std::string_view why_not_leave() const override;
  /// Stops the saw and asks: finish, abandon, or go on.
  bool ask_before_leaving(Ui& ui) override;
  /// Covered by another screen, or by the lock: nobody holds the saw.
  void leave(Shell&) override { session_.pause(PausedBy::Locked); }
  void be_covered() override { session_.pause(PausedBy::Covered); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  /// The attempt that runs, with what follows it.
  struct Running {
    std::unique_ptr<LiveAttempt> live;
    /// Of live.
    simulator::SteeredDevice* device = nullptr;
    /// After live, whose feed it follows.
    std::unique_ptr<BoneBeingCut> bone;
    /// Once the saw is to be heard.
    std::unique_ptr<SawPlayer> player;
    /// The newest of this frame; the site is null before it is known.
    simulator::LoopView loop;
    std::shared_ptr<const SiteFacts> site;
  };
  /// What of the help beside the bone is shown, each by its key.
  struct Help {
    bool is_plane_shown = true, is_hinted = true, is_inset_shown = true;
  };
  struct Panels {
    bool are_shown = true, is_health_open = false, is_neighbour_shown = true, are_hints_low = false;
    Help help;
    /// Of the arm's force.
    RecentLimits limits;
    /// Of this frame; nothing where it is not shown.
    std::optional<BladeSection> inset;
  };
  using Phase = OperatingSession::Phase;

  const PreparedCase& prepared_case() const { return *prepared_.value().prepared_case; }

  void prepare(Ui& ui, Shell& shell);
  void begin(Ui& ui, Shell& shell);
  LiveBegin what_to_begin() const;

  void draw_operation(Ui& ui, Shell& shell);
  void hear_hands(Ui& ui, const AreaResponse& area, Shell& shell);
  void hear_keys(Ui& ui);
  void hear_display_keys(Ui& ui, Preferences& preferences);
  void take_up_last_step();
  /// Leads the saw by what was steered, or sets the hand down.
  void lead(Ui& ui, const AreaResponse& area, const Steered& steered, bool may_capture);
  void apply_loop(Ui& ui, Shell& shell);
  void tell(const Ui& ui, Shell& shell, std::span<const StepNotice> notices) const;
  void show_scene(Ui& ui, Shell& shell);
  void sound_the_saw(Shell& shell);
  /// The cut in which the saw is, else the one that the step at hand asks for; nothing where the
  /// plan is not shown.
  const scenarios::PlannedCut* shown_cut() const;
  /// Of the cut of the step at hand, as far as it is known; null where it has none.
  const scenarios::HeldCut* held_at_step() const;

  void draw_cards(Ui& ui, Shell& shell);
  void draw_ready(Ui& ui, Shell& shell);
  void draw_hud(Ui& ui, Shell& shell);
  OperatingHud hud(const Ui& ui, Shell& shell);
  HandState hand(const Ui& ui) const;
  /// Of the section in the blade's plane; null where it is not shown.
  const BladeSection* inset();
  OperatingHealth health(const Ui& ui, Shell& shell);
  void ask(Ui& ui);
  void draw_stopped(Ui& ui, Shell& shell);

  void lead_on(Ui& ui, Shell& shell);
  void score(const Ui& ui, Shell& shell);
  void show_result(Shell& shell);

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  OperationChoice choice_;
  LendDevice lend_device_;
  /// Of the last frame.
  const Texts* texts_ = nullptr;
  Loaded<PreparedOperation> prepared_;
  ScreenWork work_;
  std::unique_ptr<Running> running_;
  OperatingSession session_;
  OperatingViewport viewport_;
  Panels panels_;
};

}  // namespace hallux::ui
