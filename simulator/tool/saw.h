/// The saw: its blade, its drive and its sharpness.
///
///        handle                               teeth
///     ============[ collar ]-----------------|
///                           <-- depth_mm --->|
///
///     x: feed direction, from the handle to the teeth
///     y: along the tooth line, width_mm in all
///     z: the blade's normal; kerf_mm is cut out of bone, thickness_mm of steel goes through
///
/// Made once from the scenario (scenarios/simulation_setup.h) and passed whole to whatever cuts,
/// heats, bends, sounds or is drawn. What it does to bone is the room's that does it (README.md).
#pragma once

namespace hallux::simulator {

struct Blade {
  /// Along the tooth line.
  double width_mm = 10.0;
  /// From the tooth line back to the collar.
  double depth_mm = 20.0;
  /// Thickness of what is taken away.
  double kerf_mm = 0.5;
  /// Thickness of the steel; the set of the teeth widens it to the kerf.
  double thickness_mm = 0.4;

  friend bool operator==(const Blade&, const Blade&) = default;
};

struct Saw {
  Blade blade = {};
  /// Of the drive.
  double cycles_per_minute = 12000.0;
  /// What the blade takes in a cycle, as a share of a new one's; above 0, at most 1.
  double sharpness = 1.0;

  friend bool operator==(const Saw&, const Saw&) = default;
};

/// The rate of a saw with a new blade that cuts as fast.
double sharp_cycles_per_minute(const Saw& saw) noexcept;

}  // namespace hallux::simulator
