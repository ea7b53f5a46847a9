/// The wire driver: a Kirschner wire with its trocar point, and the drive that turns it.
/// Inside this room only.
///
///     driver                                       point
///     =====[ chuck ]------------------------------->
///                   <--------- length_mm --------->      x: along the axis, from driver to point
///
/// A wire is its own drill: what it bores is as thick as it is, and it may stay in the bone.
/// source  reference, domain 3.1: diameters and the trocar point (own knowledge there, to be
///         checked by a surgeon); lengths, point and rate are ours
#pragma once

#include <array>

#include "simulator/tool/size_range.h"

namespace hallux::simulator {

struct Wire {
  double diameter_mm = 1.6;
  /// From the chuck to the tip of the point.
  double length_mm = 120.0;
  /// Of the trocar point, from its tip back to the full diameter.
  double point_mm = 3.0;

  friend bool operator==(const Wire&, const Wire&) = default;
};

/// As they lie on a tray.
inline constexpr std::array<double, 6> wire_diameters_mm{0.9, 1.1, 1.25, 1.4, 1.6, 2.0};
inline constexpr SizeRange wire_diameter_range_mm{0.9, 2.0};
inline constexpr SizeRange wire_length_range_mm{50.0, 300.0};
/// At the least a blunt trocar, at the most a needle: in diameters.
inline constexpr SizeRange wire_point_range{0.5, 4.0};

struct WireDriver {
  Wire wire = {};
  double revolutions_per_minute = 1000.0;
  /// What the point takes in a turn, as a share of a new one's; above 0, at most 1.
  double sharpness = 1.0;

  friend bool operator==(const WireDriver&, const WireDriver&) = default;
};

/// Whether all of a wire's sizes are within what is made.
bool is_made(const Wire& wire) noexcept;

}  // namespace hallux::simulator
