/// The screwdriver: a bone screw, and the drive that turns it. Inside this room only.
///
///     driver  head            thread           tip
///     ======[|####|/\/\/\/\/\/\/\/\/\/\/\/\/\/\>
///             <--> head_height_mm
///                 <--------- length_mm -------->      x: along the axis, from head to tip
///
/// A screw goes by its pitch in each turn: along a hole that is as thick as its core, or, where it
/// is self-drilling, into bone like a drill of that diameter, until its head meets the bone.
/// source  reference, domain 3.1: threads with their pilot and glide holes (own knowledge there, to
///         be checked by a surgeon); core, head and pitch are those of ISO 5835 as remembered, not
///         checked; lengths and the rate are ours
#pragma once

#include <array>

#include "simulator/tool/size_range.h"

namespace hallux::simulator {

struct Screw {
  /// Outside of the thread.
  double thread_diameter_mm = 2.7;
  /// Of the shaft that carries it: what a self-drilling tip bores.
  double shaft_diameter_mm = 1.9;
  /// Of the drill that it asks for, where it holds and where it glides.
  double pilot_diameter_mm = 2.0;
  double glide_diameter_mm = 2.7;
  double head_diameter_mm = 5.0;
  double head_height_mm = 2.0;
  /// Way in a turn.
  double pitch_mm = 1.0;
  /// From below the head to the tip.
  double length_mm = 20.0;
  bool is_self_drilling = false;

  friend bool operator==(const Screw&, const Screw&) = default;
};

/// Cortical screws of a small-bone tray, 20 mm long.
inline constexpr std::array<Screw, 4> cortical_screws{
    Screw{2.0, 1.3, 1.5, 2.0, 4.0, 1.6, 0.6}, Screw{2.4, 1.7, 1.8, 2.4, 4.0, 1.7, 1.0},
    Screw{2.7, 1.9, 2.0, 2.7, 5.0, 2.0, 1.0}, Screw{3.5, 2.4, 2.5, 3.5, 6.0, 2.6, 1.25}};
inline constexpr SizeRange screw_thread_range_mm{1.5, 7.0};
inline constexpr SizeRange screw_length_range_mm{6.0, 80.0};
inline constexpr SizeRange screw_pitch_range_mm{0.4, 3.0};
/// A headless screw has a head that is as thick as its thread.
inline constexpr SizeRange screw_head_range_mm{1.5, 10.0};
inline constexpr SizeRange screw_head_height_range_mm{0.0, 5.0};

struct Screwdriver {
  Screw screw = {};
  /// Of a powered driver at its slow end.
  double revolutions_per_minute = 120.0;

  friend bool operator==(const Screwdriver&, const Screwdriver&) = default;
};

/// Whether all of a screw's sizes are within what is made, and fit each other: shaft within pilot,
/// pilot within thread, thread within glide hole and head.
bool is_made(const Screw& screw) noexcept;

}  // namespace hallux::simulator
