/// How far running teeth went beyond the far surface of the bone. Inside this room only.
#pragma once

#include <cstdint>
#include <span>

#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

struct OverCut {
  /// Against the approach, from where the far surface lies furthest out; 0: they stayed inside.
  double over_mm = 0.0;
  /// The longest way that the furthest tooth went in a tick.
  double bound_mm = 0.0;
  /// The first beyond the far surface, and the first at which the teeth were furthest.
  std::int64_t first_tick = 0, deepest_tick = 0;
  /// The furthest tooth.
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
};

/// The furthest of both ends and the middle of the tooth line, while the saw ran in one of these
/// kerfs. The far surface is that of the section that each was to open, within the cut's window; a
/// kerf of a fragment that lies elsewhere is measured where that was cut.
/// needs  samples and events are in the order of their ticks
OverCut measure_over_cut(const simulator::Recording& recording, const RebuiltBone& rebuilt,
                         const simulator::Bones& bones, std::span<const std::int32_t> kerfs,
                         const scenarios::PlannedCut& cut);

}  // namespace hallux::assessment
