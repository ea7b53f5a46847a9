#include "assessment/rebuild/joint_margin.h"

#include <limits>
#include <vector>

#include "assessment/rebuild/bound.h"
#include "assessment/rebuild/face_samples.h"
#include "simulator/mesh/bvh.h"

namespace hallux::assessment {

namespace {

using scenarios::Plan;

/// The joint surfaces alone. A tree is built over closed meshes: so each triangle has corners of
/// its own and a second face that looks the other way.
struct JointMesh {
  simulator::IndexedMesh mesh;
  /// Of the plan's joint surfaces, one for each triangle of the mesh.
  std::vector<std::size_t> surfaces;
};

JointMesh joint_mesh(const Plan& plan, const simulator::IndexedMesh& outer) {
  JointMesh joints;
  for (std::size_t index = 0; index < plan.joint_surfaces.size(); ++index) {
    for (const std::uint32_t triangle : plan.joint_surfaces[index].triangles) {
      const auto first = static_cast<std::uint32_t>(joints.mesh.points_mm.size());
      for (const Vec3& corner_mm : corners_of(outer, triangle))
        joints.mesh.points_mm.push_back(corner_mm);
      joints.mesh.triangles.push_back({first, first + 1, first + 2});
      joints.mesh.triangles.push_back({first, first + 2, first + 1});
      joints.surfaces.insert(joints.surfaces.end(), 2, index);
    }
  }
  return joints;
}

/// A corner of a joint's triangle that lies in an open kerf.
std::optional<JointMargin> opened_corner(const RebuiltBone& rebuilt, const Plan& plan,
                                         const simulator::IndexedMesh& outer) {
  for (std::size_t index = 0; index < plan.joint_surfaces.size(); ++index) {
    for (const std::uint32_t triangle : plan.joint_surfaces[index].triangles) {
      for (const Vec3& corner_mm : corners_of(outer, triangle)) {
        if (const std::int32_t kerf = kerf_open_at(rebuilt, corner_mm); kerf >= 0)
          return JointMargin{0.0, index, kerf, corner_mm, 0.0};
      }
    }
  }
  return std::nullopt;
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
                                                const simulator::IndexedMesh& outer,
                                                double grid_mm) {
  if (plan.joint_surfaces.empty()) return std::nullopt;
  if (std::optional<JointMargin> opened = opened_corner(rebuilt, plan, outer)) return opened;
  const JointMesh joints = joint_mesh(plan, outer);
  const simulator::Bvh tree(joints.mesh);
  JointMargin least{.margin_mm = std::numeric_limits<double>::infinity()};
  for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
    const RebuiltKerf& made = rebuilt.kerfs[static_cast<std::size_t>(kerf)];
    for (const Vec3& point_mm : points_opened(made, rebuilt.fields.field(kerf), grid_mm))
      lower(least, joints, tree, point_mm, kerf);
  }
  if (least.kerf < 0) return std::nullopt;
  // A corner of what is open lies up to a grid's diagonal from the nearest open point of the grid.
  least.bound_mm = diagonal * grid_mm + field_bound_mm + rounding_bound;
  return least;
}

}  // namespace hallux::assessment
