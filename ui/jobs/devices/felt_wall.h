/// A wall to feel: where the grip was, held from both sides, within what the device bears.
/// Inside this corner only.
#pragma once

#include "simulator/device/force_output.h"

namespace hallux::ui {

class FeltWall {
 public:
  /// Across the device's z, the way to the person, through where the grip is.
  FeltWall(const simulator::DeviceLimits& limits, double newton_per_mm, const Vec3& grip_mm);

  /// A millisecond later.
  Vec3 force_newton(const Vec3& grip_mm) noexcept;

 private:
  double newton_per_mm_, depth_mm_;
  simulator::ForceOutputSettings settings_;
  simulator::ForceOutputState state_;
};

}  // namespace hallux::ui
