#include "simulator/cutting/hole/axis_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/mesh/closest_point.h"

namespace hallux::simulator {

namespace {

/// Whether the segment goes through the inside of the triangle; along its plane it goes through
/// its edges.
bool goes_through(const Segment& segment, const std::array<Vec3, 3>& corner_mm) noexcept {
  const Vec3 way = segment.to - segment.from;
  const Vec3 one = corner_mm[1] - corner_mm[0], other = corner_mm[2] - corner_mm[0];
  const Vec3 normal = glm::cross(one, other), from = segment.from - corner_mm[0];
  const double across = -glm::dot(way, normal);
  if (across == 0.0) return false;
  const Vec3 turned = glm::cross(from, way);
  const double share = glm::dot(from, normal) / across;
  const double on_one = glm::dot(other, turned) / across,
               on_other = -glm::dot(one, turned) / across;
  return share >= 0.0 && share <= 1.0 && on_one >= 0.0 && on_other >= 0.0 &&
         on_one + on_other <= 1.0;
}

double squared_distance_mm2(const Segment& segment, const std::array<Vec3, 3>& corner_mm) noexcept {
  if (goes_through(segment, corner_mm)) return 0.0;
  double least_mm2 = std::numeric_limits<double>::infinity();
  for (const Vec3& end_mm : {segment.from, segment.to}) {
    const Vec3 closest_mm = closest_on_triangle(corner_mm, end_mm).point_mm;
    least_mm2 = std::min(least_mm2, squared_length(end_mm - closest_mm));
  }
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const Segment side{corner_mm[edge], corner_mm[(edge + 1) % 3]};
    least_mm2 = std::min(least_mm2, hallux::squared_distance_mm2(segment, side));
  }
  return least_mm2;
}

}  // namespace

std::optional<double> axis_clearance_mm(const Segment& axis, const IndexedMesh& mesh,
                                        std::span<const std::uint32_t> triangles) noexcept {
  if (triangles.empty()) return std::nullopt;
  double least_mm2 = std::numeric_limits<double>::infinity();
  for (const std::uint32_t triangle : triangles)
    least_mm2 = std::min(least_mm2, squared_distance_mm2(axis, corners_of(mesh, triangle)));
  return std::sqrt(least_mm2);
}

}  // namespace hallux::simulator
