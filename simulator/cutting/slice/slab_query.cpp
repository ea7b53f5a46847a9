#include "simulator/cutting/slice/slab_query.h"

#include <cmath>
#include <utility>

#include "simulator/cutting/slice/id_table.h"

namespace hallux::simulator {

namespace {

/// The tree's boxes and this file may round a height differently.
double search_margin_mm(const KerfAxes& axes) noexcept {
  return 1.0e-6 + 1.0e-12 * std::abs(glm::dot(axes.z, axes.origin_mm));
}

bool reaches_into_slab(const IndexedMesh& mesh, const KerfAxes& axes, std::uint32_t triangle,
                       double half_mm) noexcept {
  bool all_above = true, all_below = true;
  for (const std::uint32_t corner : mesh.triangles[triangle]) {
    const SlabPart part = slab_part(height_mm(axes, mesh.points_mm[corner]), half_mm);
    all_above = all_above && part == SlabPart::Above;
    all_below = all_below && part == SlabPart::Below;
  }
  return !all_above && !all_below;
}

}  // namespace

std::vector<std::uint32_t> triangles_reaching_slab(const IndexedMesh& mesh, const Bvh& bvh,
                                                   const KerfAxes& axes, double half_mm) {
  std::vector<std::uint32_t> triangles;
  bvh.triangles_in_slab(axes.z, glm::dot(axes.z, axes.origin_mm), half_mm + search_margin_mm(axes),
                        triangles);
  std::erase_if(triangles, [&](std::uint32_t triangle) {
    return !reaches_into_slab(mesh, axes, triangle, half_mm);
  });
  return triangles;
}

SlabSkin gather_slab_skin(const IndexedMesh& mesh, const Bvh& bvh, const KerfAxes& axes,
                          double half_mm) {
  SlabSkin skin;
  skin.triangles = triangles_reaching_slab(mesh, bvh, axes, half_mm);
  skin.corners.reserve(skin.triangles.size());
  skin.points.reserve(skin.triangles.size());
  IdTable ids(skin.triangles.size());
  for (const std::uint32_t triangle : skin.triangles) {
    Triangle& corners = skin.corners.emplace_back(mesh.triangles[triangle]);
    for (std::uint32_t& corner : corners) {
      bool is_new = false;
      const std::uint32_t point = std::exchange(corner, ids.id_of(corner, is_new));
      if (!is_new) continue;
      const Vec3& point_mm = mesh.points_mm[point];
      const double corner_mm = height_mm(axes, point_mm);
      skin.points.push_back({point_mm, corner_mm, point, slab_part(corner_mm, half_mm)});
    }
  }
  return skin;
}

}  // namespace hallux::simulator
