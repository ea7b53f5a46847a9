/// The point of a triangle that is nearest to a point, and the part of the triangle it lies on.
/// Inside this room only.
#pragma once

#include <array>
#include <cstddef>

#include "simulator/base/vector.h"

namespace hallux::simulator {

enum class TrianglePart { Face, Edge, Corner };

struct ClosestPoint {
  Vec3 point_mm{0.0, 0.0, 0.0};
  TrianglePart part = TrianglePart::Face;
  /// Of the corner, or of the corner where the edge begins.
  std::size_t index = 0;
};

/// source  Ericson, Real-Time Collision Detection (2005), 5.1.5
ClosestPoint closest_on_triangle(const std::array<Vec3, 3>& corner_mm,
                                 const Vec3& point_mm) noexcept;
/// The same on the three edges only: right for triangles too thin for a plane of their own.
ClosestPoint closest_on_edges(const std::array<Vec3, 3>& corner_mm, const Vec3& point_mm) noexcept;

}  // namespace hallux::simulator
