/// How near the opened bone comes to a joint's surface. Inside this room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"
#include "simulator/mesh/bones.h"

namespace hallux::assessment {

struct JointMargin {
  /// 0 where the surface itself is opened.
  double margin_mm = 0.0;
  /// Of the plan's joint surfaces.
  std::size_t surface = 0;
  std::int32_t kerf = -1;
  /// On the joint's surface, in the frame of its bone.
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
  /// The margin is no further than this from the least there is, once it is rounded.
  double bound_mm = 0.0;
};

/// The least distance of what the kerfs opened inside the bone from the plan's joint surfaces:
/// of points on a grid on both walls of each kerf to the triangles of the surfaces, and 0
/// where a corner of such a triangle lies in an open kerf. Nothing where no bone was opened, or the
/// plan has no joint surface.
/// Of each bone the kerfs in it and the surfaces on it.
std::optional<JointMargin> measure_joint_margin(const RebuiltBone& rebuilt,
                                                const scenarios::Plan& plan,
                                                const simulator::Bones& bones,
                                                double grid_mm = 0.1);

}  // namespace hallux::assessment
