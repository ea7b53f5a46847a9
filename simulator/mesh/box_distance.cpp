#include "simulator/mesh/box_distance.h"

#include <algorithm>
#include <cmath>

/// The nearest point of the triangle lies on one of its sides or inside it. On a side the squared distance to the box is
/// convex and piecewise quadratic with breaks where the side passes the planes of the box's faces: its least is found in
/// closed form. Inside, the nearest point lies straight under the corner of the box that is furthest towards the
/// triangle's plane; where several corners are, the sides find as near a point or any of the corners will do.
namespace hallux::simulator {

namespace {

Vec3 in_box(const Vec3& point_mm, const Vec3& half_mm) noexcept {
  return glm::clamp(point_mm, -half_mm, half_mm);
}

BoxGap gap_of_point(const Vec3& point_mm, const Vec3& half_mm) noexcept {
  const Vec3 on_box_mm = in_box(point_mm, half_mm);
  const Vec3 apart = point_mm - on_box_mm;
  return {glm::dot(apart, apart), point_mm, on_box_mm};
}

/// Half the slope of the squared distance; rises with the share.
double slope_at(const Vec3& from_mm, const Vec3& way_mm, double share,
                const Vec3& half_mm) noexcept {
  const Vec3 point_mm = from_mm + share * way_mm;
  return glm::dot(way_mm, point_mm - in_box(point_mm, half_mm));
}

BoxGap gap_of_side(const Vec3& from_mm, const Vec3& to_mm, const Vec3& half_mm) noexcept {
  const Vec3 way_mm = to_mm - from_mm;
  double low = 0.0, high = 1.0;
  double low_slope = slope_at(from_mm, way_mm, low, half_mm);
  double high_slope = slope_at(from_mm, way_mm, high, half_mm);
  if (low_slope >= 0.0) return gap_of_point(from_mm, half_mm);
  if (high_slope <= 0.0) return gap_of_point(to_mm, half_mm);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    for (const double plane_mm : {-half_mm[axis], half_mm[axis]}) {
      const double share = (plane_mm - from_mm[axis]) / way_mm[axis];
      if (!(share > low && share < high)) continue;
      const double slope = slope_at(from_mm, way_mm, share, half_mm);
      (slope < 0.0 ? low : high) = share;
      (slope < 0.0 ? low_slope : high_slope) = slope;
    }
  }
  // No break lies between the two any more: the slope is a straight line.
  const double part = low_slope < high_slope ? low_slope / (low_slope - high_slope) : 0.0;
  return gap_of_point(from_mm + (low + part * (high - low)) * way_mm, half_mm);
}

/// Whether a point of the triangle's plane lies inside the triangle.
bool is_over(const std::array<Vec3, 3>& corner_mm, const Vec3& normal,
             const Vec3& point_mm) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = corner_mm[k];
    const Vec3& b = corner_mm[(k + 1) % 3];
    if (glm::dot(normal, glm::cross(b - a, point_mm - a)) < 0.0) return false;
  }
  return true;
}

}  // namespace

BoxGap box_gap(const std::array<Vec3, 3>& corner_mm, const Vec3& half_mm) noexcept {
  BoxGap best = gap_of_side(corner_mm[0], corner_mm[1], half_mm);
  for (std::size_t k = 1; k < 3; ++k) {
    const BoxGap gap = gap_of_side(corner_mm[k], corner_mm[(k + 1) % 3], half_mm);
    if (gap.squared_mm2 < best.squared_mm2) best = gap;
  }
  const Vec3 normal = glm::cross(corner_mm[1] - corner_mm[0], corner_mm[2] - corner_mm[0]);
  const double squared_length = glm::dot(normal, normal);
  if (!(squared_length > 0.0)) return best;
  const double height = glm::dot(normal, corner_mm[0]);
  const Vec3 most(normal.x < 0.0 ? -half_mm.x : half_mm.x, normal.y < 0.0 ? -half_mm.y : half_mm.y,
                  normal.z < 0.0 ? -half_mm.z : half_mm.z);
  const double reach = glm::dot(normal, most);
  if (std::abs(height) <= reach) {
    // The plane cuts the box, and where the triangle covers the whole cut no side meets the box.
    const Vec3 inside_mm = reach > 0.0 ? (height / reach) * most : Vec3(0.0);
    if (is_over(corner_mm, normal, inside_mm)) return {0.0, inside_mm, inside_mm};
    return best;
  }
  const Vec3 nearest_mm = height > 0.0 ? most : -most;
  const double away = height - glm::dot(normal, nearest_mm);
  const Vec3 under_mm = nearest_mm + (away / squared_length) * normal;
  const double squared_mm2 = away * away / squared_length;
  if (squared_mm2 < best.squared_mm2 && is_over(corner_mm, normal, under_mm)) {
    best = {squared_mm2, under_mm, nearest_mm};
  }
  return best;
}

}  // namespace hallux::simulator
