/// One way in which a hand is to hold the blade still, and does not quite: it wanders, notices, and
/// undoes it. Inside this corner only.
#pragma once

#include <array>

#include "simulator/base/random.h"

namespace hallux::scenarios {

/// The wander of a hand that nobody corrects: three slow waves with phases of their own, within
/// +-1.
class Wander {
 public:
  explicit Wander(Random random) noexcept;
  double at(double time_s) const noexcept;

 private:
  struct Wave {
    double rate_rad_s = 0.0, phase_rad = 0.0;
  };
  std::array<Wave, 3> waves_{};
};

/// A deviation out of the plane, in millimetres or radians.
class HeldAxis {
 public:
  HeldAxis(Random random, double wander, double steadying_per_s) noexcept
      : wander_(random), size_(wander), steadying_per_s_(steadying_per_s) {}

  /// Goes on by a span to `time_s` in bone; `noticed` is the deviation as the hand noticed it.
  /// thread  haptic; allocates nothing
  void hold(double time_s, double span_s, double noticed) noexcept;
  /// Goes on likewise with its eyes on it: hardly wanders, and comes to what it means.
  void bring(double time_s, double span_s) noexcept;
  double value() const noexcept { return share_ * size_ * wave_ + correction_; }
  /// The value that it means to keep from now on.
  void mean(double value) noexcept { meant_ = value; }
  /// It is here, and means to come to nothing: the plane that it is counted from was laid anew.
  void put(double value) noexcept;

 private:
  Wander wander_;
  double size_, steadying_per_s_;
  /// Of its size by which it wanders now.
  double share_ = 0.0;
  /// Of the wander, within +-1.
  double wave_ = 0.0;
  /// By which it was undone so far.
  double correction_ = 0.0;
  /// The value that it means to keep.
  double meant_ = 0.0;
};

}  // namespace hallux::scenarios
