/// Fields that random blades opened: thick and thinner than a node's spacing, turned, in islands
/// and around holes.
#pragma once

#include "simulator/base/random.h"
#include "simulator/cutting/field/kerf.h"

namespace hallux::tests {

struct RandomStamp {
  simulator::Blade blade;
  simulator::PlanarPose from, to;
};

/// 81 x 81 nodes, 8 mm wide: two and a half tiles.
inline constexpr double small_half_mm = 4.0;
simulator::FieldGrid small_grid();

/// A motion of a blade somewhere in the small grid, now and then beyond its border.
RandomStamp random_stamp(Random& random);

}  // namespace hallux::tests
