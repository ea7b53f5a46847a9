/// The hinge: a thin bridge becomes a joint, and the wedge beside it is closed by turning one body
/// about it.
///
/// No mesh is bent. The bone is divided without loss through the bridge, and one half turns about
/// the bridge's inner edge until the faces of the wedge touch; what the halves then overlap lies
/// inside the bridge.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/base/units.h"
#include "simulator/cutting/hinge/hinge_gap.h"
#include "simulator/cutting/hinge/turn_contact.h"
#include "simulator/cutting/slice/section.h"

namespace hallux::simulator {

/// The kerf number of the two faces that divide_at_hinge makes: no blade cut them.
inline constexpr std::int32_t hinge_face = -2;

/// A bone in two halves, on either side of a kerf's middle plane.
struct DividedBone {
  /// Along the kerf's z; both closed.
  CutSolid above, below;
  /// Corners of the faces, one list per part of the section.
  std::vector<std::vector<Vec3>> bridges_in_bone_mm;
  /// Their areas.
  std::vector<double> bridges_mm2;
};

/// Divides what the plane crosses, with nothing lost.
/// needs   solid is closed, its kerfs are gaps in it; bvh was built over solid.mesh; the plane
///         crosses only the bridge
/// ensures above and below are closed and share no point; their volumes add up to the solid's;
///         triangles that do not cross the plane keep their bits
DividedBone divide_at_hinge(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane);

/// A bridge that is to be left and closed, said in the frame of its bone.
struct PlannedBridge {
  HingeLine line;
  /// From the half that stays to the one that turns.
  Vec3 toward_moved{1.0, 0.0, 0.0};
  double breaks_below_mm = 0.3, bends_up_to_mm = 2.5;
  /// Of the patient's bones.
  std::int32_t bone = 0;
};
/// Of an operation, in its order.
using PlannedBridges = std::vector<PlannedBridge>;

/// The bridge as the jobs ask for it.
struct HingeRequest {
  /// Of the two kerfs that end at the bridge.
  KerfPlane first, second;
  /// Measured in them.
  HingeGap first_gap, second_gap;
  PlannedBridge bridge;
  /// Below pi / 2.
  double most_rad = radian_from_degree(45.0);
};

enum class HingeOutcome : std::int32_t {
  /// The faces touch.
  Closed,
  /// Too thin, or cut through: the halves are two bodies without a joint.
  Broken,
  /// Too thick to bend, or bone elsewhere in the plane still holds: nothing moves.
  Stiff,
  /// Nothing touches within most_rad: there is no wedge to close.
  FacesMissing
};

struct ClosedHinge {
  HingeOutcome outcome = HingeOutcome::Stiff;
  double thickness_mm = 0.0;
  /// Where it is closed; moved as it was before the turn.
  CutSolid fixed, moved;
  /// A positive turn closes.
  TurnAxis joint;
  double angle_rad = 0.0;
  /// Carries `moved` to where it lies when closed.
  RigidTransform bone_from_moved;
  Vec3 contact_in_bone_mm{0.0, 0.0, 0.0};
  /// Nearer to the joint the bodies may overlap: the bridge and a kerf beyond.
  double bridge_radius_mm = 0.0;
};

/// Strips beside the bridge that the blade missed break when it closes, as long as their sections
/// together are no more than this part of the bridge's own; then the bodies may overlap as near to
/// the joint as they reach.
inline constexpr double weak_remnant_part = 0.1;

/// Closes the wedge beside the bridge.
/// needs   as divide_at_hinge, for the kerf that left less bone; solid holds nothing that lies in
///         the wedge
/// ensures pure and the same on every machine
ClosedHinge close_hinge(const CutSolid& solid, const Bvh& bvh, const HingeRequest& request);

}  // namespace hallux::simulator
