#include "simulator/cutting/slab_query.h"

#include <algorithm>
#include <cmath>

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

}  // namespace hallux::simulator
