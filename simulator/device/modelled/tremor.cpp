#include "simulator/device/modelled/tremor.h"

#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/random.h"
#include "simulator/base/units.h"

namespace hallux::simulator {

Tremor::Tremor(std::uint64_t seed, double size_mm) noexcept
    : amplitude_mm_(size_mm * std::sqrt(2.0 / static_cast<double>(waves_per_axis))) {
  Random random(seed, "hand.tremor");
  for (auto& axis : waves_) {
    for (Wave& wave : axis) {
      wave = {random.uniform(8.0, 12.0), random.uniform(0.0, 2.0 * pi)};
    }
  }
}

Vec3 Tremor::at(double time_s) const noexcept {
  Vec3 away_mm(0.0, 0.0, 0.0);
  for (std::size_t axis = 0; axis < waves_.size(); ++axis) {
    for (const Wave& wave : waves_[axis]) {
      // Whole turns are left out: the sine is exact for small angles only.
      const double turns = wave.turns_per_s * time_s;
      const double angle_rad = 2.0 * pi * (turns - std::floor(turns)) + wave.phase_rad;
      away_mm[static_cast<int>(axis)] += amplitude_mm_ * elementary::sin(angle_rad);
    }
  }
  return away_mm;
}

}  // namespace hallux::simulator
