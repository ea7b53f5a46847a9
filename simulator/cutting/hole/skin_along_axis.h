/// A closed skin seen along an axis: its triangles in a frame whose z is the axis, and where lines
/// parallel to the axis cross them. Inside this corner only.
///
/// A line crosses a triangle by the parity of its edges to the right of the line. Each edge is
/// judged from its lower end whichever triangle asks, on coordinates that a corner has alone; so
/// through an edge or a corner a line passes exactly once, and as often in as out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

/// A frame of the body's with z along an axis.
struct AxisFrame {
  Vec3 origin_mm{0.0, 0.0, 0.0};
  Vec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

  Vec3 to_local(const Vec3& point_mm) const noexcept {
    const Vec3 arm = point_mm - origin_mm;
    return {glm::dot(x, arm), glm::dot(y, arm), glm::dot(z, arm)};
  }
  Vec3 to_body(const Vec3& local_mm) const noexcept {
    return origin_mm + local_mm.x * x + local_mm.y * y + local_mm.z * z;
  }
};

/// The frame of the axis from one point towards another; of points that coincide, along the body's
/// z.
AxisFrame frame_along(const Vec3& from_mm, const Vec3& to_mm) noexcept;

struct LocalTriangle {
  std::array<Vec3, 3> corner_mm;
  std::uint32_t triangle = 0;
};

/// Where a line goes into the solid or out of it.
struct LineCrossing {
  double height_mm = 0.0;
  /// 1: in, -1: out.
  int turn = 0;
  std::uint32_t triangle = 0;
};

/// A part of a line within the solid.
struct InsideInterval {
  double from_mm = 0.0, to_mm = 0.0;
  std::uint32_t from_triangle = 0, to_triangle = 0;
};

/// Nearer than this to each other, going in and out are one touch.
inline constexpr double grazing_mm = 1.0e-6;

/// Replaces `triangles` by all that may come within the radius of the endless axis.
void find_triangles_along(const Bvh& skin, const AxisFrame& frame, double radius_mm,
                          std::vector<LocalTriangle>& triangles);

/// The crossing of the line through (place, any z).
std::optional<LineCrossing> crossing_of(const LocalTriangle& triangle,
                                        const Vec2& place_mm) noexcept;

/// Sorts the crossings of one line; the parts of it within the solid, in order. Touches are none.
/// shape   `intervals` is replaced
void find_inside(std::vector<LineCrossing>& crossings, std::vector<InsideInterval>& intervals);

}  // namespace hallux::simulator
