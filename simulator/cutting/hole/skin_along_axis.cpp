#include "simulator/cutting/hole/skin_along_axis.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

namespace {

/// An axis shorter than this has no direction.
constexpr double point_mm = 1.0e-6;

/// Where an edge passes the line's y.
struct Passing {
  double x_mm = 0.0, z_mm = 0.0;
};

Passing passing(const Vec3& lower, const Vec3& upper, double y_mm) noexcept {
  const double share = (y_mm - lower.y) / (upper.y - lower.y);
  return {lower.x + share * (upper.x - lower.x), lower.z + share * (upper.z - lower.z)};
}

}  // namespace

AxisFrame frame_along(const Vec3& from_mm, const Vec3& to_mm) noexcept {
  AxisFrame frame;
  frame.origin_mm = from_mm;
  const Vec3 way = to_mm - from_mm;
  const double length_mm = length_of(way);
  if (!(length_mm > point_mm)) return frame;
  frame.z = way / length_mm;
  const Vec3 size{std::abs(frame.z.x), std::abs(frame.z.y), std::abs(frame.z.z)};
  Vec3 across{1.0, 0.0, 0.0};
  if (size.y < size.x && size.y <= size.z) across = Vec3{0.0, 1.0, 0.0};
  if (size.z < size.x && size.z < size.y) across = Vec3{0.0, 0.0, 1.0};
  frame.x = unit(glm::cross(across, frame.z));
  frame.y = glm::cross(frame.z, frame.x);
  return frame;
}

void find_triangles_along(const Bvh& skin, const AxisFrame& frame, double radius_mm,
                          std::vector<LocalTriangle>& triangles) {
  triangles.clear();
  skin.visit_line(
      frame.origin_mm, frame.z, radius_mm,
      [&](std::uint32_t triangle, const std::array<Vec3, 3>& corner_mm) {
        triangles.push_back({{frame.to_local(corner_mm[0]), frame.to_local(corner_mm[1]),
                              frame.to_local(corner_mm[2])},
                             triangle});
      });
}

std::optional<LineCrossing> crossing_of(const LocalTriangle& triangle,
                                        const Vec2& place_mm) noexcept {
  std::array<Passing, 2> passings;
  std::size_t count = 0;
  int turn = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = triangle.corner_mm[i];
    const Vec3& b = triangle.corner_mm[(i + 1) % 3];
    if ((a.y <= place_mm.y) == (b.y <= place_mm.y)) continue;
    const bool goes_up = a.y < b.y;
    const Vec3& lower = goes_up ? a : b;
    const Vec3& upper = goes_up ? b : a;
    const double side =
        (upper.x - lower.x) * (place_mm.y - lower.y) - (upper.y - lower.y) * (place_mm.x - lower.x);
    // Seen from +z an outward face turns left: its edge to the right of the line goes up.
    if (side > 0.0) turn += goes_up ? -1 : 1;
    passings[count++] = passing(lower, upper, place_mm.y);
  }
  if (turn == 0) return std::nullopt;
  const double width_mm = passings[1].x_mm - passings[0].x_mm;
  const double share =
      width_mm == 0.0 ? 0.5 : std::clamp((place_mm.x - passings[0].x_mm) / width_mm, 0.0, 1.0);
  return LineCrossing{passings[0].z_mm + share * (passings[1].z_mm - passings[0].z_mm), turn,
                      triangle.triangle};
}

void find_inside(std::vector<LineCrossing>& crossings, std::vector<InsideInterval>& intervals) {
  std::sort(crossings.begin(), crossings.end(), [](const LineCrossing& a, const LineCrossing& b) {
    if (a.height_mm != b.height_mm) return a.height_mm < b.height_mm;
    return a.turn != b.turn ? a.turn > b.turn : a.triangle < b.triangle;
  });
  intervals.clear();
  int depth = 0;
  for (const LineCrossing& crossing : crossings) {
    const int before = depth;
    depth += crossing.turn;
    if (before == 0 && depth == 1) {
      const bool goes_on =
          !intervals.empty() && crossing.height_mm - intervals.back().to_mm < grazing_mm;
      if (!goes_on) intervals.push_back({crossing.height_mm, 0.0, crossing.triangle, 0});
    }
    if (before == 1 && depth == 0) {
      intervals.back().to_mm = crossing.height_mm;
      intervals.back().to_triangle = crossing.triangle;
    }
  }
  std::erase_if(intervals, [](const InsideInterval& interval) {
    return interval.to_mm - interval.from_mm < grazing_mm;
  });
}

}  // namespace hallux::simulator
