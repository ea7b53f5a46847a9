/// Distances of straight pieces of a line. Inside this room only.
#pragma once

#include <algorithm>

#include "simulator/base/vector.h"

namespace hallux {

struct Segment {
  Vec3 from, to;
};

/// A segment shorter than this is a point [mm squared].
inline constexpr double point_segment_mm2 = 1.0e-12;

inline Vec3 closest_on_segment(const Segment& segment, const Vec3& point_mm) noexcept {
  const Vec3 along = segment.to - segment.from;
  const double length2 = squared_length(along);
  if (!(length2 > point_segment_mm2)) return segment.from;
  const double share = glm::dot(point_mm - segment.from, along) / length2;
  return segment.from + std::clamp(share, 0.0, 1.0) * along;
}

/// source  Ericson 2005, Real-Time Collision Detection, 5.1.9
inline double squared_distance_mm2(const Segment& a, const Segment& b) noexcept {
  const Vec3 along_a = a.to - a.from, along_b = b.to - b.from, between = a.from - b.from;
  const double aa = squared_length(along_a), bb = squared_length(along_b),
               ab = glm::dot(along_a, along_b);
  const double ar = glm::dot(along_a, between), br = glm::dot(along_b, between);
  double share_a = 0.0, share_b = 0.0;
  if (aa > point_segment_mm2) {
    const double cross = aa * bb - ab * ab;
    if (cross > 0.0) share_a = std::clamp((ab * br - ar * bb) / cross, 0.0, 1.0);
  }
  if (bb > point_segment_mm2) share_b = std::clamp((ab * share_a + br) / bb, 0.0, 1.0);
  if (aa > point_segment_mm2) share_a = std::clamp((ab * share_b - ar) / aa, 0.0, 1.0);
  return squared_length(between + share_a * along_a - share_b * along_b);
}

}  // namespace hallux
