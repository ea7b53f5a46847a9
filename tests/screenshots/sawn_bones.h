/// The worlds of the pictures: the phalanx of the shipped Akin plan, sawn by the kernel, and what a
/// frame shows as scenes.
#pragma once

#include <utility>
#include <vector>

#include "scenarios/plan.h"
#include "simulator/cutting/hinge/hinge_gap.h"
#include "simulator/cutting/solid/solid_patch.h"
#include "tests/screenshots/scene.h"

namespace hallux::tests {

/// A patient with the plan of an operation; the bone in its own frame: x distal, y dorsal, z
/// lateral.
struct PlannedBone {
  scenarios::Scenario scenario;
  simulator::Bone bone;
  scenarios::Plan plan;
  /// Outer surface and canal.
  simulator::CutSolid solid;
};

/// The shipped Akin operation on its patient, meshed with edges of this length.
PlannedBone akin_phalanx(double edge_mm);

/// The plane in which a blade makes a planned face: half a kerf into the waste. The frame's origin
/// lies at the hinge's point, x feeds from the entry towards it, y runs along the tooth line.
simulator::KerfPlane planned_kerf(const PlannedBone& bone, std::size_t cut, double kerf_mm);

/// The hinge of the plan as the kernel measures it.
simulator::HingeLine planned_hinge_line(const PlannedBone& bone);

/// The same plane with its frame's origin at another place of it.
simulator::KerfPlane moved_in_plane(const simulator::KerfPlane& plane, const Vec2& origin_mm);
/// The point of the bone at a place of the kerf's plane and a height over it.
Vec3 point_in_bone_mm(const simulator::KerfPlane& plane, const Vec2& place_mm,
                      double height_mm = 0.0);

/// 0.05 mm between nodes, 24 mm to each side of the frame's origin.
simulator::FieldGrid wide_grid();
/// What a blade opens on straight ways from pose to pose.
void saw(simulator::KerfField& field, const simulator::Blade& blade,
         const std::vector<simulator::PlanarPose>& poses);

/// A frame of a kerf in a solid, with all that led to it.
struct SawnFrame {
  simulator::SlabSlice contact;
  simulator::RegionOutline region;
  simulator::SolidPatch patch;
};
/// The frame in which the region of `field` is open.
SawnFrame frame_of(const simulator::CutSolid& solid, const simulator::KerfPlane& plane,
                   const simulator::KerfField& field, std::int32_t kerf = 0);

/// Of each of a patch's triangles: outer part, strip, wall or front.
std::vector<Paint> paints_of(const simulator::CutSolid& solid, const SawnFrame& frame);
/// What stands and the patch, painted by kind.
Scene shown_scene(const simulator::CutSolid& solid, const SawnFrame& frame);

/// Of each triangle of a solid that was cut: skin, or the wall or front of a kerf; kerf 0 is
/// painted as the earlier one where `has_earlier`.
std::vector<Paint> paints_of(const simulator::CutSolid& solid, bool has_earlier);

/// A triangle's place among a kerf's planes: +1 beyond the upper one with a corner, -1 beyond the
/// lower one, 0 between.
int level_of(const simulator::KerfPlane& plane, const simulator::IndexedMesh& mesh,
             const simulator::Triangle& corners);

}  // namespace hallux::tests
