/// The area within an outline.
#pragma once

#include "simulator/cutting/field/region_outline.h"

namespace hallux::tests {

/// Sum of the loops' signed areas: what is opened, less the holes.
inline double area_mm2(const simulator::RegionOutline& outline) {
  double doubled_mm2 = 0.0;
  std::size_t first = 0;
  for (const std::size_t last : outline.loop_ends) {
    const Vec2 origin_mm = outline.corners_mm[first];
    for (std::size_t i = first + 1; i + 1 < last; ++i) {
      const Vec2 a_mm = outline.corners_mm[i] - origin_mm;
      const Vec2 b_mm = outline.corners_mm[i + 1] - origin_mm;
      doubled_mm2 += a_mm.x * b_mm.y - a_mm.y * b_mm.x;
    }
    first = last;
  }
  return 0.5 * doubled_mm2;
}

}  // namespace hallux::tests
