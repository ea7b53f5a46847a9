/// What every operation in the window has: a session led by hands, the loop that runs, and the bone
/// that it cuts, seen and heard. What it is for, its cards and its end are its screen's.
///
///     keys, pointer --> session --> loop --> picture, sound, facts of the panels
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/jobs/commanded_loop.h"
#include "ui/jobs/devices/lent_hand.h"
#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/screens/operating/hud_facts.h"
#include "ui/screens/operating/operating_session.h"
#include "ui/screens/operating/operating_viewport.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/sound/saw_player.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class OperatingField {
 public:
  OperatingField(database::AttemptKind kind, simulator::Guidance guidance)
      : guidance_(guidance), session_(kind) {}

  OperatingSession& session() noexcept { return session_; }
  const OperatingSession& session() const noexcept { return session_; }
  const OperatingViewport& viewport() const noexcept { return viewport_; }
  /// needs   made ready
  const PreparedOperation& prepared() const noexcept { return prepared_; }
  const PreparedCase& prepared_case() const noexcept { return *prepared_.prepared_case; }

  /// The session is ready, and the camera stands before the site.
  void make_ready(PreparedOperation prepared);
  /// The same with steps of its own.
  void make_ready(PreparedOperation prepared, StepProgress steps);
  /// The session runs, and the picture follows the loop. Borrows loop and device.
  /// name    for the names of the pictures
  /// second  of the other hand; null: none
  void run(const std::string& name, CommandedLoop& loop, simulator::SteeredDevice& device,
           std::unique_ptr<simulator::SecondHand> second = nullptr);
  bool is_running() const noexcept { return running_ != nullptr; }
  /// Where the saw is held when it begins.
  HandStart start() const {
    return {session_.saw().world_from_target(), viewport_.world_from_view()};
  }

  // -- of a frame, in this order
  /// Hears hands and keys, and leads the saw.
  void hear(Ui& ui, Shell& shell);
  /// Takes what came back from the loop since the last frame; told are the steps that did not come
  /// off.
  void apply_loop(Ui& ui, Shell& shell);
  /// Draws the picture behind the widgets, and sounds the saw.
  /// goals  marked in the picture
  void show(Ui& ui, Shell& shell, std::span<const Mark> goals = {});
  /// Last: who was asked something in this frame has the pointer at once.
  void hold_pointer(Ui& ui, const Preferences& preferences) const;

  // -- what there is to tell; needs it is running
  /// As of this frame.
  const simulator::LoopView& loop() const noexcept { return running_->view; }
  /// Why the device is away, and what mends it; empty where it is well.
  std::string device_trouble() const;
  /// Null before it is known.
  const SiteFacts* site() const noexcept { return running_->site.get(); }
  HudSources sources(const Texts& texts) const;
  /// Of the cut of the step at hand, as far as it is known; null where it has none.
  const scenarios::HeldCut* held_at_step() const;
  bool are_panels_shown() const noexcept { return panels_.are_shown; }
  bool is_health_open() const noexcept { return panels_.is_health_open; }
  bool is_hinted() const noexcept { return panels_.help.is_hinted; }
  /// What all operations show, of hand, health and inset too.
  OperatingHud hud(const Ui& ui, Shell& shell);
  /// Does what was pressed, as far as it is no end, step or lesson.
  void answer(const HudAnswer& answer, const Texts& texts);

 private:
  /// The loop that runs, with what follows it.
  struct Running {
    CommandedLoop& loop;
    simulator::SteeredDevice& device;
    std::unique_ptr<simulator::SecondHand> second;
    BoneBeingCut bone;
    /// Once the saw is to be heard.
    std::unique_ptr<SawPlayer> player = {};
    /// When the other hand was asked last.
    double asked_s = 0.0;
    /// The newest of this frame; the site is null before it is known.
    simulator::LoopView view = {};
    std::shared_ptr<const SiteFacts> site = {};
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

  void hear_keys(Ui& ui);
  void hear_tool_keys(Ui& ui);
  void hear_display_keys(Ui& ui, Shell& shell);
  void take_up_step(const Texts& texts);
  /// Leads the saw by what was steered, or sets the hand down.
  void lead(Ui& ui, const AreaResponse& area, const Steered& steered);
  void tell(const Ui& ui, Shell& shell, std::span<const Notice> notices) const;
  void sound_the_saw(Shell& shell);
  void see_saw();
  void work_forceps(const Texts& texts);
  void leave_or_take();
  /// Of the other hand since the last frame: what of it is the saw's; the rest turns the view.
  simulator::PointerMotion hear_second(double now_s);
  /// Something may change that nobody did at this window.
  bool is_waiting() const;
  /// The cut in which the saw is, else the one that the step at hand asks for; null where people
  /// are to know nothing of the plan.
  const scenarios::PlannedCut* known_cut() const;
  simulator::Saw driven_saw() const;
  /// What is to be set and shifted now, for the picture.
  void show_fixation(OperationInSight& shown, const Texts& texts) const;
  HandState hand(const Ui& ui) const;
  /// Of the section in the blade's plane; null where it is not shown.
  const BladeSection* inset(const std::optional<WayAhead>& way);
  OperatingHealth health(const Ui& ui, Shell& shell);

  simulator::Guidance guidance_;
  PreparedOperation prepared_;
  std::unique_ptr<Running> running_;
  OperatingSession session_;
  OperatingViewport viewport_;
  Panels panels_;
};

}  // namespace hallux::ui
