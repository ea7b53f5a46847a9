/// The session of somebody who operates: phases, pauses, tools, steps, questions and the end. Draws
/// nothing, knows no window. Inside this corner only.
///
///     preparing -> ready -> beginning -> operating -> sealing -> scoring -> over
///                    '<--stopped by person-'  |          |--------------> over, abandoned
///                                             '----------+-- a failure -> stopped, with why
///
/// A view tells it what the person did and draws what it says. It leads an attempt and steers a
/// device, both lent to it:
///
///     keys, pointer --> session --aim--> device --> loop --events--> session
///                          '--commands--> attempt ---'
///
/// A full disk ends nothing: the attempt pauses; it stops only for whoever does not wait for room.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "database/records/attempt.h"
#include "ui/jobs/attempt_controls.h"
#include "ui/screens/operating/hand/led_saw.h"
#include "ui/screens/operating/hand/notice.h"
#include "ui/screens/operating/hand/tools_in_hand.h"
#include "ui/screens/operating/pausing.h"
#include "ui/screens/operating/step_progress.h"

namespace hallux::ui {

/// A question that nothing else goes on beside.
enum class Asked {
  Nothing,
  Finish,
  Abandon,
  /// The step is to end though bone still holds in its cut.
  EndUnfinished,
  /// The window is to be closed, or the screen left.
  Leave,
  /// Which tool of the tray comes into the hand; the time goes on meanwhile.
  Tool
};

/// What a person decides of it.
enum class Decided { GoOn, Act, Finish };

/// What a frame saw of the person's hands.
struct HandsSeen {
  bool have_lost_keys = false;
  /// The pointer left the window while it led the saw.
  bool has_pointer_left = false;
  /// Something lies over the picture and takes what is pressed.
  bool is_covered = false;
};

class OperatingSession {
 public:
  enum class Phase { Preparing, Ready, Beginning, Operating, Sealing, Scoring, Over, Stopped };
  /// Why it may not be left.
  enum class Staying { No, WhileRecorded, WhileScored };
  /// How the end of an attempt leads on.
  enum class Onward { Nowhere, Stopped, Abandoned, Score };
  /// Why it stopped.
  struct Stop {
    LiveFailure failure = LiveFailure::None;
    /// As the one who noticed it said it.
    std::string reason = {};
    /// The file that was recorded into.
    std::filesystem::path file = {};
  };

  explicit OperatingSession(database::AttemptKind kind) : kind_(kind) {}

  bool is_practice() const noexcept { return kind_ == database::AttemptKind::Practice; }
  Phase phase() const noexcept { return phase_; }
  const LedSaw& saw() const noexcept { return saw_; }
  const ToolsInHand& tools() const noexcept { return tools_; }
  const Pausing& pausing() const noexcept { return pausing_; }
  /// The device that a hand held is away.
  bool is_device_lost() const noexcept { return is_device_lost_; }
  const StepProgress& steps() const noexcept { return steps_; }
  Asked asked() const noexcept { return asking_.what; }
  Staying staying() const noexcept;
  /// needs   it is stopped
  const Stop& stop() const noexcept { return stop_; }
  /// The moment from which on it is sealed.
  double ended_s() const noexcept { return ending_.since_s; }

  /// Whether the view may be turned: nothing is asked, and it has not ended.
  bool is_open() const noexcept { return asked() == Asked::Nothing && phase_ < Phase::Sealing; }
  /// Whether keys and buttons of an operation are heard.
  bool is_heard() const noexcept { return is_open() && phase_ == Phase::Operating; }
  /// Whether somebody leads the saw.
  bool is_led() const noexcept { return is_heard() && !pausing_.is_paused(); }

  // -- before
  /// Preparing -> ready.
  void make_ready(StepProgress steps, const LedSaw& saw, ToolsInHand tools = {});
  /// Ready -> beginning. False where that is not so.
  bool begin() noexcept;
  /// Beginning -> operating. Borrows both.
  void run(AttemptControls& attempt, simulator::SteeredDevice& device) noexcept;
  /// Beginning -> ready: the person stopped it.
  void take_back() noexcept { phase_ = Phase::Ready; }
  /// Beginning -> stopped.
  void fail_to_begin(const std::string& reason);

  // -- the hands
  void set_saw_on(bool is_on) noexcept { saw_.set_on(is_on && !pausing_.is_paused()); }
  void set_irrigated(bool is_irrigated) noexcept { saw_.set_irrigated(is_irrigated); }
  /// Takes the hand off the saw, or puts it on again where both are.
  void lift(bool is_lifted) noexcept;
  void set_rail(const std::optional<simulator::Rail>& rail) noexcept { saw_.set_rail(rail); }
  /// Moves the saw on; once a frame.
  /// needs   is_led
  void lead(std::span<const simulator::PointerMotion> motions, const Quat& world_from_view,
            double now_s) noexcept {
    saw_.lead(motions, world_from_view, now_s);
  }
  /// Pauses where hands were taken off the saw: it runs only while somebody can hear, see and stop
  /// it.
  void watch(const HandsSeen& hands, double now_s);
  /// Nothing but while operating.
  void pause(PausedBy by);
  void go_on();
  void toggle_pause();

  /// Where the loop has put the saw, and what runs (bits of Switch).
  void see_saw(const RigidTransform& world_from_tool, std::uint32_t switches) noexcept {
    saw_.see(world_from_tool, switches);
  }
  /// Pauses while the device is away; it goes on by itself once it is there again.
  void see_device(bool is_lost);
  /// Mouse and keys lead on in place of the device that is away; in practice alone.
  void take_over_from_device();

  // -- the tools; nothing but while somebody leads
  /// The tray is open, and the drive off.
  void open_tray();
  /// The tray is closed; a tool of it is taken up, where one was chosen.
  void close_tray(std::optional<std::int32_t> place);
  /// Grips that piece with open forceps; closed ones let go.
  void work_forceps(std::optional<std::int32_t> piece);
  /// What the forceps hold.
  void drive_home();
  /// The driver lets go of what stands in bone, or takes hold of that implant.
  void leave_or_take(bool stands_in_bone, std::optional<std::int32_t> implant);

  // -- steps
  /// The button of the step at hand. Where bone still holds in the cut of that step it asks first,
  /// once.
  /// is_cut_through  of the step at hand; true where it has no cut
  void press_step(bool is_cut_through, double now_s);
  /// A done step is at hand again, or another that may be done next is; nothing where that cannot
  /// be.
  void take_up_step(std::size_t step);
  /// What the steps that remove ask for, in their order, as it lies in the wound now.
  void see(std::span<const scenarios::WantedPart> parts) { steps_.see(parts); }
  /// Takes what happened at the bone since the last frame; told is what did not come off.
  std::vector<Notice> apply(std::span<const simulator::CutEvent> events, double now_s);

  // -- the end
  /// Pauses and asks; nothing but while operating without a question.
  void ask(Asked what);
  /// Acts on a question about an end: finishes, abandons, ends the step. To leave may be decided
  /// either way, finished or (Act) abandoned. Else it goes on as it was, unless a disk filled up
  /// meanwhile.
  void answer(Decided decided, double now_s);
  /// Waits for a disk that is full. True where that changed.
  bool update_storage();
  /// Waits no longer for room: ends as a failure of the disk does.
  void abandon_unstored(double now_s);
  /// Takes the end of the attempt, once.
  Onward take_end();
  /// Scoring -> over.
  void close() noexcept { phase_ = Phase::Over; }

 private:
  struct Asking {
    Asked what = Asked::Nothing;
    bool was_paused = false;
  };
  struct Ending {
    double since_s = 0.0;
    bool is_abandoned = false;
  };

  void end_step();
  void end_attempt(bool is_abandoned, double now_s);
  void seal(double now_s) noexcept;

  database::AttemptKind kind_;
  Phase phase_ = Phase::Preparing;
  AttemptControls* attempt_ = nullptr;
  LedSaw saw_;
  ToolsInHand tools_;
  Pausing pausing_;
  StepProgress steps_;
  bool is_device_lost_ = false;
  /// The step of which it was asked whether it ends unfinished.
  std::optional<std::size_t> asked_of_step_;
  Asking asking_;
  Ending ending_;
  Stop stop_;
};

}  // namespace hallux::ui
