/// A planned face as a frame to draw it in, as far as it lies in the bone.
#pragma once

#include <span>
#include <vector>

#include "scenarios/plan.h"
#include "simulator/base/transform.h"
#include "simulator/bone/cut_bone.h"
#include "simulator/mesh/bones.h"

namespace hallux::ui {

/// The middle of the face; z towards the waste, x from where the blade enters to where it comes
/// out.
RigidTransform bone_from_planned(const scenarios::PlannedCut& cut) noexcept;

/// A rectangle around the part of a section in which a cut is made: a face along a shaft meets the
/// bone's other end as well, and of that nothing is shown.
struct PlannedFace {
  /// Its middle; axes as they were asked for.
  RigidTransform bone_from_face;
  /// A rim around the bone is in it.
  Vec2 half_mm{15.0, 12.0};
  /// Where its rim lies on the -x side of the middle.
  double entry_x_mm = 0.0;
};

/// `place_in_bone_mm` lies in or near the part that is meant.
/// needs   tree was built over solid.mesh
PlannedFace planned_face(const simulator::CutSolid& solid, const simulator::Bvh& tree,
                         const RigidTransform& bone_from_plane, const Vec3& place_in_bone_mm);
/// The same of each cut of a plan, in its order, said in the frame of the first bone.
/// wholes  by bone, as they were
std::vector<PlannedFace> planned_faces(std::span<const simulator::SolidWithTree> wholes,
                                       const scenarios::Plan& plan, const simulator::Bones& bones);

}  // namespace hallux::ui
