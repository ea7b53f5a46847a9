/// How the saw was minded: run in the air, started in bone, kept wet. Inside this room only.
#pragma once

#include <optional>

#include "assessment/process/finding.h"
#include "simulator/mesh/bvh.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

struct SawCare {
  /// Seconds in stretches of more than 2 s in which the saw ran, no tooth touched bone, and the
  /// teeth were within 50 mm of it; its moment is the longest of them.
  Finding air_s;
  /// 1 where the saw was switched on while teeth touched bone; its moment is the first time.
  Finding started_in_bone;
  /// Of the time in which teeth advanced in bone, the share with water; nothing where they never
  /// did. Its moment is the first stretch without.
  std::optional<Finding> irrigated_share;
};

/// surface  of the bone as it was, in its frame
/// needs    samples are in the order of their ticks
SawCare measure_saw_care(const simulator::Recording& recording, const simulator::Bvh& surface,
                         const RigidTransform& bone_from_world);

}  // namespace hallux::assessment
