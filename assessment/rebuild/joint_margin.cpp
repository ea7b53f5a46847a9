#include "assessment/rebuild/joint_margin.h"

#include <limits>
#include <vector>

#include "assessment/rebuild/bound.h"
#include "assessment/rebuild/face_samples.h"
#include "simulator/mesh/bvh.h"

namespace hallux::assessment {

namespace {

using scenarios::Plan;

/// The joint surfaces of one bone alone. A tree is built over closed meshes: so each triangle has
/// corners of its own and a second face that looks the other way.
struct JointMesh {
  simulator::IndexedMesh mesh;
  /// Of the plan's joint surfaces, one for each triangle of the mesh.
  std::vector<std::size_t> surfaces;
};

/// visit(index, triangle) of every triangle of a joint surface on that bone.
template <typename Visit>
void visit_joints(const Plan& plan, std::size_t bone, const Visit& visit) {
  for (std::size_t index = 0; index < plan.joint_surfaces.size(); ++index) {
    if (plan.joint_surfaces[index].bone != bone) continue;
    for (const std::uint32_t triangle : plan.joint_surfaces[index].triangles)
      visit(index, triangle);
  }
}

JointMesh joint_mesh(const Plan& plan, const simulator::Bones& bones, std::size_t bone) {
  JointMesh joints;
  visit_joints(plan, bone, [&](std::size_t index, std::uint32_t triangle) {
    const auto first = static_cast<std::uint32_t>(joints.mesh.points_mm.size());
    for (const Vec3& corner_mm : corners_of(bones[bone].outer, triangle))
      joints.mesh.points_mm.push_back(corner_mm);
    joints.mesh.triangles.push_back({first, first + 1, first + 2});
    joints.mesh.triangles.push_back({first, first + 2, first + 1});
    joints.surfaces.insert(joints.surfaces.end(), 2, index);
  });
  return joints;
}

/// A corner of a joint's triangle that lies in an open kerf.
std::optional<JointMargin> opened_corner(const RebuiltBone& rebuilt, const Plan& plan,
                                         const simulator::Bones& bones) {
  std::optional<JointMargin> opened;
  for (std::size_t bone = 0; bone < bones.size() && !opened; ++bone) {
    visit_joints(plan, bone, [&](std::size_t index, std::uint32_t triangle) {
      for (const Vec3& corner_mm : corners_of(bones[bone].outer, triangle)) {
        if (opened) return;
        if (const std::int32_t kerf = kerf_open_at(rebuilt, bone, corner_mm); kerf >= 0)
          opened = JointMargin{0.0, index, kerf, corner_mm, 0.0};
      }
    });
  }
  return opened;
}

/// Lowers the margin to that of one opened point.
void lower(JointMargin& least, const JointMesh& joints, const simulator::Bvh& tree,
           const Vec3& point_mm, std::int32_t kerf) {
  const auto nearest = tree.nearest(point_mm, least.margin_mm);
  if (!nearest || nearest->distance_mm >= least.margin_mm) return;
  least.margin_mm = nearest->distance_mm;
  least.surface = joints.surfaces[nearest->triangle];
  least.kerf = kerf;
  least.place_in_bone_mm = nearest->point_mm;
}

}  // namespace

std::optional<JointMargin> measure_joint_margin(const RebuiltBone& rebuilt, const Plan& plan,
                                                const simulator::Bones& bones, double grid_mm) {
  if (std::optional<JointMargin> opened = opened_corner(rebuilt, plan, bones)) return opened;
  JointMargin least{.margin_mm = std::numeric_limits<double>::infinity()};
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    const JointMesh joints = joint_mesh(plan, bones, bone);
    if (joints.surfaces.empty()) continue;
    const simulator::Bvh tree(joints.mesh);
    for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
      if (bone_of(rebuilt, kerf) != bone) continue;
      const RebuiltKerf& made = rebuilt.kerfs[static_cast<std::size_t>(kerf)];
      for (const Vec3& point_mm : points_opened(made, rebuilt.fields.field(kerf), grid_mm))
        lower(least, joints, tree, point_mm, kerf);
    }
  }
  if (least.kerf < 0) return std::nullopt;
  // A corner of what is open lies up to a grid's diagonal from the nearest open point of the grid.
  least.bound_mm = diagonal * grid_mm + field_bound_mm + rounding_bound;
  return least;
}

}  // namespace hallux::assessment
