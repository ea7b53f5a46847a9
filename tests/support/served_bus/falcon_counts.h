/// What a Falcon's encoders say where its grip is.
#pragma once

#include <cmath>

#include "simulator/device/falcon/falcon_kinematics.h"

namespace hallux::tests {

/// The nearest counts. needs   a place that its legs reach
inline simulator::FalconCounts falcon_counts_at(const Vec3& grip_mm) {
  const simulator::CrankAngles angles = simulator::crank_angles(grip_mm).value();
  const simulator::CrankAngles at_0 = simulator::crank_angles_at({0, 0, 0});
  const simulator::CrankAngles at_1 = simulator::crank_angles_at({1, 1, 1});
  simulator::FalconCounts counts{};
  for (std::size_t leg = 0; leg < simulator::falcon_legs; ++leg) {
    counts[leg] =
        static_cast<std::int32_t>(std::lround((angles[leg] - at_0[leg]) / (at_1[leg] - at_0[leg])));
  }
  return counts;
}

}  // namespace hallux::tests
