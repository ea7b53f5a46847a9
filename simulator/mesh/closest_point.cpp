#include "simulator/mesh/closest_point.h"

#include <limits>

namespace hallux::simulator {

namespace {

ClosestPoint on_corner(const std::array<Vec3, 3>& corner_mm, std::size_t index) noexcept {
  return {corner_mm[index], TrianglePart::Corner, index};
}

/// On the edge from corner `index` to the next, at the fraction above / (above + below) of it; both
/// are positive.
ClosestPoint on_edge(const std::array<Vec3, 3>& corner_mm, std::size_t index, double above,
                     double below) noexcept {
  const Vec3& begin = corner_mm[index];
  const Vec3& end = corner_mm[(index + 1) % 3];
  return {begin + (above / (above + below)) * (end - begin), TrianglePart::Edge, index};
}

}  // namespace

ClosestPoint closest_on_triangle(const std::array<Vec3, 3>& corner_mm,
                                 const Vec3& point_mm) noexcept {
  const Vec3 ab = corner_mm[1] - corner_mm[0];
  const Vec3 ac = corner_mm[2] - corner_mm[0];
  const Vec3 from_a = point_mm - corner_mm[0];
  const double d1 = glm::dot(ab, from_a);
  const double d2 = glm::dot(ac, from_a);
  if (d1 <= 0.0 && d2 <= 0.0) return on_corner(corner_mm, 0);

  const Vec3 from_b = point_mm - corner_mm[1];
  const double d3 = glm::dot(ab, from_b);
  const double d4 = glm::dot(ac, from_b);
  if (d3 >= 0.0 && d4 <= d3) return on_corner(corner_mm, 1);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 > 0.0 && d3 < 0.0) return on_edge(corner_mm, 0, d1, -d3);

  const Vec3 from_c = point_mm - corner_mm[2];
  const double d5 = glm::dot(ab, from_c);
  const double d6 = glm::dot(ac, from_c);
  if (d6 >= 0.0 && d5 <= d6) return on_corner(corner_mm, 2);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 > 0.0 && d6 < 0.0) return on_edge(corner_mm, 2, -d6, d2);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 > d3 && d5 > d6) return on_edge(corner_mm, 1, d4 - d3, d5 - d6);

  const double sum = va + vb + vc;
  return {corner_mm[0] + (vb / sum) * ab + (vc / sum) * ac, TrianglePart::Face, 0};
}

ClosestPoint closest_on_edges(const std::array<Vec3, 3>& corner_mm, const Vec3& point_mm) noexcept {
  ClosestPoint best;
  double least_mm2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& begin = corner_mm[i];
    const Vec3 along = corner_mm[(i + 1) % 3] - begin;
    const double above = glm::dot(along, point_mm - begin);
    const double below = glm::dot(along, along) - above;
    ClosestPoint found;
    if (above <= 0.0) {
      found = on_corner(corner_mm, i);
    } else if (below <= 0.0) {
      found = on_corner(corner_mm, (i + 1) % 3);
    } else {
      found = on_edge(corner_mm, i, above, below);
    }
    const Vec3 apart = point_mm - found.point_mm;
    if (const double mm2 = glm::dot(apart, apart); mm2 < least_mm2) {
      least_mm2 = mm2;
      best = found;
    }
  }
  return best;
}

}  // namespace hallux::simulator
