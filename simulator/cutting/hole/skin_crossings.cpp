#include "simulator/cutting/hole/skin_crossings.h"

namespace hallux::simulator {

std::vector<InsideInterval> inside_intervals(const Bvh& skin, const Vec3& from_mm,
                                             const Vec3& to_mm) {
  const AxisFrame frame = frame_along(from_mm, to_mm);
  std::vector<LocalTriangle> triangles;
  find_triangles_along(skin, frame, 0.0, triangles);
  std::vector<LineCrossing> crossings;
  for (const LocalTriangle& triangle : triangles) {
    if (const auto crossing = crossing_of(triangle, Vec2{0.0, 0.0})) crossings.push_back(*crossing);
  }
  std::vector<InsideInterval> intervals;
  find_inside(crossings, intervals);
  return intervals;
}

std::vector<SkinCrossing> skin_crossings(const Bvh& skin, const Vec3& from_mm, const Vec3& to_mm) {
  const AxisFrame frame = frame_along(from_mm, to_mm);
  const double length_mm = length_of(to_mm - from_mm);
  std::vector<SkinCrossing> crossings;
  const auto add = [&](double way_mm, bool goes_in, std::uint32_t triangle) {
    if (way_mm < 0.0 || way_mm > length_mm) return;
    crossings.push_back({way_mm, frame.to_body(Vec3{0.0, 0.0, way_mm}), goes_in, triangle});
  };
  for (const InsideInterval& inside : inside_intervals(skin, from_mm, to_mm)) {
    add(inside.from_mm, true, inside.from_triangle);
    add(inside.to_mm, false, inside.to_triangle);
  }
  return crossings;
}

}  // namespace hallux::simulator
