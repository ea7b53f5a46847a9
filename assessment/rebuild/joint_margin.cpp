#include "assessment/rebuild/joint_margin.h"

#include <cmath>
#include <limits>
#include <vector>

#include "assessment/rebuild/face_samples.h"

namespace hallux::assessment {

namespace {

using scenarios::Plan;

constexpr double grid_mm = 0.1;

/// Per triangle of the outer surface the joint surface it belongs to, from 1 on; 0: none.
std::vector<std::uint8_t> surfaces_of(const Plan& plan, std::size_t triangle_count) {
  std::vector<std::uint8_t> surfaces(triangle_count, 0);
  for (std::size_t index = 0; index < plan.joint_surfaces.size(); ++index) {
    for (const std::uint32_t triangle : plan.joint_surfaces[index].triangles)
      surfaces[triangle] = static_cast<std::uint8_t>(index + 1);
  }
  return surfaces;
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
void lower(JointMargin& least, const simulator::Bvh& tree,
           const std::vector<std::uint8_t>& surfaces, const Vec3& point_mm, std::int32_t kerf) {
  tree.visit_near(point_mm, least.margin_mm, [&](const simulator::NearTriangle& near) -> double {
    const std::uint8_t surface = surfaces[near.triangle];
    const double distance_mm = length_of(near.closest_mm - point_mm);
    if (surface == 0 || distance_mm >= least.margin_mm) return least.margin_mm;
    least.margin_mm = distance_mm;
    least.surface = surface - 1U;
    least.kerf = kerf;
    least.place_in_bone_mm = near.closest_mm;
    return distance_mm;
  });
}

}  // namespace

std::optional<JointMargin> measure_joint_margin(const RebuiltBone& rebuilt, const Plan& plan,
                                                const simulator::IndexedMesh& outer,
                                                const simulator::Bvh& tree) {
  if (plan.joint_surfaces.empty()) return std::nullopt;
  if (std::optional<JointMargin> opened = opened_corner(rebuilt, plan, outer)) return opened;
  const std::vector<std::uint8_t> surfaces = surfaces_of(plan, outer.triangles.size());
  JointMargin least{.margin_mm = std::numeric_limits<double>::infinity()};
  for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
    for (const std::int32_t side : {-1, 1}) {
      const auto& made = rebuilt.kerfs[static_cast<std::size_t>(kerf)];
      for (const Vec3& point_mm : points_opened(made, rebuilt.fields.field(kerf), side, grid_mm))
        lower(least, tree, surfaces, point_mm, kerf);
    }
  }
  if (least.kerf < 0) return std::nullopt;
  // Half of a grid's diagonal.
  least.bound_mm = grid_mm * std::sqrt(0.5);
  return least;
}

}  // namespace hallux::assessment
