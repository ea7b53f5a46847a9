/// What a hand feels and sees of the blade, and when it notices it: a reaction time later, the
/// depth as well as its eye is. Inside this corner only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "scenarios/hands/hand_skill.h"
#include "simulator/base/random.h"

namespace hallux::scenarios {

/// In the blade's plane: feed along x, out of it along z.
struct Sensed {
  /// That the hand gives along the feed.
  double push_newton = 0.0;
  /// On the hand, out of the plane.
  double aside_newton = 0.0;
  /// Of the tooth line in bone.
  double engaged_mm = 0.0;
  /// Of the teeth, as they are or as the eye has it.
  double feed_mm = 0.0;
  /// Of the blade out of the plane that the hand keeps to.
  double out_mm = 0.0;
  /// Of the handle out of that plane.
  double tilt_x_rad = 0.0, tilt_y_rad = 0.0;
};

class HandSenses {
 public:
  HandSenses(const Perception& perception, Random random) noexcept;

  /// Takes in how it is now; a state of 1 to 3 ticks.
  /// thread  haptic; allocates nothing
  void observe(const Sensed& now, std::int64_t ticks) noexcept;
  const Sensed& noticed() const noexcept { return noticed_; }
  /// Of the teeth as the eye follows them, over about a fifth of a second [mm/s].
  double noticed_feed_mm_s() const noexcept { return feed_mm_s_; }

 private:
  /// More than the slowest reaction of a hand.
  static constexpr std::size_t capacity = 1024;

  std::size_t reaction_ticks_;
  double eye_mm_;
  Random random_;
  std::array<Sensed, capacity> past_{};
  std::size_t next_ = 0, known_ = 0;
  std::int64_t ticks_to_glance_ = 0;
  double eye_error_mm_ = 0.0;
  Sensed noticed_;
  double feed_mm_s_ = 0.0, followed_feed_mm_ = 0.0;
};

}  // namespace hallux::scenarios
