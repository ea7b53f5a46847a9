/// How hard the hand pushed while teeth advanced in bone. Inside this room only.
#pragma once

#include <optional>

#include "assessment/process/finding.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// Nothing where no tooth advanced for long enough.
struct Pushes {
  /// The greatest mean of the force on the hand over 20 ms in which teeth advanced at each tick: a
  /// single sample costs nothing.
  std::optional<Finding> peak_newton;
  /// The 95th percentile of the force on the hand, linear between order statistics; its moment is
  /// that of all the sawing.
  std::optional<Finding> p95_newton;
  /// The root mean square of the force along the blade's normal; its moment likewise.
  std::optional<Finding> side_newton;
};

/// needs   samples are in the order of their ticks
Pushes measure_pushes(const simulator::Recording& recording);

}  // namespace hallux::assessment
