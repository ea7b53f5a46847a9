#include "tests/benchmarks/kernel/strokes.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::benchmarks {

simulator::PlanarPose sway_through(double share) {
  const double angle_rad = 0.05 * std::sin(2.0 * pi * share);
  return {Vec2(-8.0 + 18.5 * share, 2.0 * std::sin(3.0 * pi * share)),
          Vec2(std::cos(angle_rad), std::sin(angle_rad))};
}

simulator::PlanarPose SawingStroke::operator()(double share) const {
  const double forward = std::min(1.0, share / 0.8);
  return {Vec2(begin_mm + (end_mm - begin_mm) * forward,
               reach_mm * std::sin(2.0 * pi * rounds * share)),
          Vec2(1.0, 0.0)};
}

}  // namespace hallux::benchmarks
