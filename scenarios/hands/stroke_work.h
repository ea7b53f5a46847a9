/// One stroke of a saw as a hand carries it out: by what it feels and sees, tick by tick.
/// Inside this corner only.
///
///     Reach -> Lower -> Seek --bone felt--> Push --line or far side--> LetGo -> Withdraw -> Done
///                        ^                   |
///                        |-- GiveBack <------| push fell off, or nothing is there: bone gave way
///                        |-- Return <- Clear <| sawed long enough, or nothing moves
///                        |-- Return <- Leave <| draws the blade out on purpose
///                                      Look <-> in doubt how deep it is
#pragma once

#include <algorithm>
#include <cstdint>

#include "scenarios/hands/hand_senses.h"
#include "scenarios/hands/push_control.h"
#include "scenarios/hands/stroke_plan.h"

namespace hallux::scenarios {

/// Where a hand holds the handle in the blade's plane, and what it switches.
struct Handle {
  double feed_mm = 0.0, along_mm = 0.0;
  bool saw_runs = false, irrigates = false;
};

/// Moves the handle along the feed by at most so much; whether it is there.
inline bool lead_to(Handle& handle, double feed_mm, double most_mm) noexcept {
  handle.feed_mm += std::clamp(feed_mm - handle.feed_mm, -most_mm, most_mm);
  return handle.feed_mm == feed_mm;
}

/// How far in front of the bone a hand waits between strokes [mm].
inline constexpr double hover_mm = 15.0;

class StrokeWork {
 public:
  StrokeWork(const HandSkill& skill, std::uint64_t seed);

  void begin(const Stroke& stroke) noexcept;
  /// Moves the handle on by a span. `felt_newton` is the push that it gives at this moment.
  /// thread  haptic; allocates nothing
  void go_on(Handle& handle, const HandSenses& senses, double felt_newton, double span_s) noexcept;
  bool is_done() const noexcept { return phase_ == Phase::Done; }
  /// The blade is in the air, or on its way through what is open: the hand looks where it puts it.
  bool is_free() const noexcept { return phase_ != Phase::Push && phase_ != Phase::Look; }

 private:
  enum class Phase {
    Reach,
    Lower,
    Seek,
    Push,
    Look,
    GiveBack,
    Clear,
    Leave,
    Return,
    LetGo,
    Rest,
    Withdraw,
    Done
  };

  void reach(Handle& handle, double span_s) noexcept;
  void seek(Handle& handle, const HandSenses& senses, double span_s) noexcept;
  double meant_newton(const Sensed& noticed) const noexcept;
  void push(Handle& handle, const HandSenses& senses, double felt_newton, double span_s) noexcept;
  void look(Handle& handle, const HandSenses& senses, double felt_newton, double span_s) noexcept;
  bool feels_nothing(const HandSenses& senses) const noexcept;
  void decide_while_pushing(const HandSenses& senses) noexcept;
  void lead(Handle& handle, double meant_newton, const HandSenses& senses, double felt_newton,
            double span_s) noexcept;
  void mind_water(Handle& handle, double span_s) noexcept;
  void enter(Phase phase) noexcept;
  bool goes_to(Handle& handle, double feed_mm, double speed_mm_s, double span_s) const noexcept;
  bool is_in_doubt(double remaining_mm) const noexcept;

  HandSkill skill_;
  Random water_;
  WantedPush wanted_;
  Stroke stroke_;
  Phase phase_ = Phase::Done;
  /// Since it began.
  double phase_s_ = 0.0;
  /// Likewise, of the stroke.
  double stroke_s_ = 0.0;
  /// Sawed since the blade was drawn back.
  double burst_s_ = 0.0;
  /// Pushed without seeing progress.
  double still_s_ = 0.0;
  /// Since it looked how deep it is.
  double unseen_s_ = 0.0;
  /// Until it notices that no water runs.
  double dry_s_ = 0.0;
  /// The push that it is used to.
  double level_newton_ = 0.0;
  std::int32_t restarts_left_ = 0;
  /// Where it saw the teeth when it drew the blade back.
  double turned_at_mm_ = 0.0;
};

}  // namespace hallux::scenarios
