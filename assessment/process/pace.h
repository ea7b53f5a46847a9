/// How long the operation took, and how much of it passed in thought. Inside this room only.
#pragma once

#include <optional>
#include <span>

#include "assessment/process/finding.h"
#include "assessment/process/handle_track.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// Time runs while the attempt's clock does: pauses are left out.
struct Pace {
  /// From started to finished; nothing where the operator did not finish.
  std::optional<Finding> time_s;
  /// From started to the first tick in which teeth advanced in bone; nothing where none did.
  std::optional<Finding> planning_s;
  /// In stretches of more than 1.5 s in which the handle moved slower than 2 mm/s and no tooth
  /// advanced; its moment is the longest of them.
  Finding idle_s;
};

/// stretches  of this recording (see handle_stretches)
/// needs      samples and events are in the order of their ticks
Pace measure_pace(const simulator::Recording& recording, std::span<const HandleStretch> stretches);

}  // namespace hallux::assessment
