/// The drill: a twist bit and the drive that turns it. Inside this room only.
///
///     drive                           tip
///     =====[ chuck ]~~~~~~~~~~~~~~~~~~>
///                   <-- length_mm --->      x: along the axis, from drive to tip
///
/// source  reference, domain 3.1: diameters (own knowledge there, to be checked by a surgeon);
///         lengths, the point's angle and the rate are ours
#pragma once

#include <array>

#include "simulator/tool/size_range.h"

namespace hallux::simulator {

struct DrillBit {
  double diameter_mm = 2.0;
  /// From the chuck to the tip.
  double length_mm = 60.0;
  /// Of the cone at the tip: a point of 118 degrees is 0.3 diameters long.
  double point_mm = 0.6;

  friend bool operator==(const DrillBit&, const DrillBit&) = default;
};

/// As they lie on a tray.
inline constexpr std::array<double, 7> drill_diameters_mm{1.1, 1.5, 1.8, 2.0, 2.5, 2.7, 3.2};
inline constexpr SizeRange drill_diameter_range_mm{1.1, 3.2};
inline constexpr SizeRange drill_length_range_mm{30.0, 150.0};
/// From a flat end to a point of 60 degrees: in diameters.
inline constexpr SizeRange drill_point_range{0.0, 0.87};

struct Drill {
  DrillBit bit = {};
  double revolutions_per_minute = 1000.0;
  /// What the bit takes in a turn, as a share of a new one's; above 0, at most 1.
  double sharpness = 1.0;

  friend bool operator==(const Drill&, const Drill&) = default;
};

/// Whether all of a bit's sizes are within what is made.
bool is_made(const DrillBit& bit) noexcept;

}  // namespace hallux::simulator
