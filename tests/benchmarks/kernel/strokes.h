/// How the blade moves in these benchmarks: a place along a stroke for each share of it.
#pragma once

#include <cstddef>
#include <vector>

#include "simulator/cutting/field/kerf.h"

namespace hallux::benchmarks {

/// A saw that is pushed through a shaft of oblique_kerf from outside, swaying 2 mm to each side and
/// 0.05 rad.
simulator::PlanarPose sway_through(double share);
inline constexpr simulator::Blade swaying_blade{.width_mm = 10.0, .depth_mm = 40.0, .kerf_mm = 0.5};

/// `steps` + 1 poses from the stroke's begin to its end.
template <typename Stroke>
std::vector<simulator::PlanarPose> poses_of(Stroke stroke, std::size_t steps) {
  std::vector<simulator::PlanarPose> poses;
  for (std::size_t i = 0; i <= steps; ++i) {
    poses.push_back(stroke(static_cast<double>(i) / static_cast<double>(steps)));
  }
  return poses;
}

/// A saw moved quickly up and down and gradually forward, along a sine, as in thesis 7.2: `rounds`
/// times up and down within +-`reach_mm` across; it goes from `begin_mm` to `end_mm` along the feed
/// and stays there for the last fifth.
struct SawingStroke {
  double reach_mm = 10.0, begin_mm = -10.0, end_mm = 10.0;
  double rounds = 8.0;

  simulator::PlanarPose operator()(double share) const;
};

}  // namespace hallux::benchmarks
