/// Which triangles of a view are seen, and in which order they are painted so that the nearer cover
/// the farther.
///
/// Sorting by the depth of the middles is wrong where long triangles of a wall lie beside short
/// ones of the skin. Here two triangles whose pictures overlap are compared at a point that both
/// cover; a triangle is painted when all behind it are. Closed surfaces do not pass through each
/// other, so the comparison is exact; a ring of three that overlap in turn is broken at its
/// farthest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulator/base/vector.h"

namespace hallux::tests {

struct PageTriangle {
  std::array<Vec2, 3> places_px;
  /// Greater is nearer.
  std::array<double, 3> depths{};
  /// Triangles of one paint are kept together where that is free.
  std::uint32_t paint = 0;
};

/// Those of which at least one of the samples half a pixel apart is seen, ascending. What falls
/// between the samples goes by its middle.
std::vector<std::uint32_t> seen_triangles(const std::vector<PageTriangle>& triangles);

/// The given triangles from back to front.
std::vector<std::uint32_t> painter_order(const std::vector<PageTriangle>& triangles,
                                         const std::vector<std::uint32_t>& seen);

}  // namespace hallux::tests
