#include "simulator/cutting/hole/implant_tip.h"

#include <cmath>

#include "simulator/cutting/hole/skin_crossings.h"
#include "simulator/mesh/closest_point.h"

namespace hallux::simulator {

std::optional<double> protrusion_mm(const Bvh& skin, const Vec3& head_mm, const Vec3& tip_mm) {
  const double length_mm = length_of(tip_mm - head_mm);
  std::optional<double> protrusion;
  for (const InsideInterval& inside : inside_intervals(skin, head_mm, tip_mm)) {
    if (inside.from_mm < length_mm && inside.to_mm > 0.0) protrusion = length_mm - inside.to_mm;
  }
  return protrusion;
}

std::optional<double> tip_clearance_mm(const Vec3& tip_mm, const IndexedMesh& mesh,
                                       std::span<const std::uint32_t> triangles) noexcept {
  if (triangles.empty()) return std::nullopt;
  double least_mm2 = std::numeric_limits<double>::infinity();
  for (const std::uint32_t triangle : triangles) {
    const ClosestPoint closest = closest_on_triangle(corners_of(mesh, triangle), tip_mm);
    least_mm2 = std::min(least_mm2, squared_length(tip_mm - closest.point_mm));
  }
  return std::sqrt(least_mm2);
}

}  // namespace hallux::simulator
