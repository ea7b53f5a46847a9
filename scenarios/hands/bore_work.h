/// One way of a wire, drill or screw into bone as a hand carries it out: by what it feels and sees.
/// Inside this corner only.
///
///     Reach -> Lower -> Seek --bone felt--> Push --deep enough, or it stands--> LetGo -> Done
///                        ^                   |
///                        '-------------------' nothing is felt: it is through, or in marrow
#pragma once

#include "scenarios/hands/hand_senses.h"
#include "scenarios/hands/push_control.h"
#include "scenarios/hands/stroke_work.h"

namespace hallux::scenarios {

/// Along the axis, from where it is to go in: feed is of the tip.
struct BoreTask {
  /// Feed at which bone may begin, and at which the hand means to stop.
  double first_mm = 0.0, stop_mm = 0.0;
  /// It ends where the head stands on bone: nothing moves any more.
  bool ends_seated = false;
};

class BoreWork {
 public:
  BoreWork(const HandSkill& skill, std::uint64_t seed);

  void begin(const BoreTask& task) noexcept;
  /// As StrokeWork: moves the handle on by a span.
  /// thread  haptic; allocates nothing
  void go_on(Handle& handle, const HandSenses& senses, double felt_newton, double span_s) noexcept;
  bool is_done() const noexcept { return phase_ == Phase::Done; }

 private:
  enum class Phase { Reach, Lower, Seek, Push, LetGo, Rest, Done };

  void enter(Phase phase) noexcept;
  bool goes_to(Handle& handle, double feed_mm, double span_s) const noexcept;
  void reach(Handle& handle, double span_s) noexcept;
  void seek(Handle& handle, const HandSenses& senses, double span_s) noexcept;
  void push(Handle& handle, const HandSenses& senses, double felt_newton, double span_s) noexcept;
  bool is_deep_enough(const HandSenses& senses) const noexcept;

  HandSkill skill_;
  WantedPush wanted_;
  BoreTask task_;
  Phase phase_ = Phase::Done;
  /// Since it began; since the whole way began; pushed without seeing progress.
  double phase_s_ = 0.0, way_s_ = 0.0, still_s_ = 0.0;
};

}  // namespace hallux::scenarios
