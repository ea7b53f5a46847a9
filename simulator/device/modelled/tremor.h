/// The trembling of a hand that holds still: a few sines about ten hertz in each direction, drawn
/// from a seed. Inside this corner only.
#pragma once

#include <array>
#include <cstdint>

#include "simulator/base/vector.h"

namespace hallux::simulator {

class Tremor {
 public:
  /// `size_mm` is the root mean square along each axis. Frequencies lie between 8 and 12 Hz.
  Tremor(std::uint64_t seed, double size_mm) noexcept;

  /// How far the hand is from where it would be [mm]. thread  any; no state changes
  Vec3 at(double time_s) const noexcept;

 private:
  struct Wave {
    double turns_per_s = 0.0, phase_rad = 0.0;
  };
  static constexpr std::size_t waves_per_axis = 3;

  std::array<std::array<Wave, waves_per_axis>, 3> waves_{};
  /// Of each wave.
  double amplitude_mm_ = 0.0;
};

}  // namespace hallux::simulator
