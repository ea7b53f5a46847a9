/// Heat at the teeth of a saw: what they give to the bone, how it cools, and what it does to the
/// bone.
///
///     dT/dt = power / capacity - (T - 37) / cooling_s - (rinsed: rinse_per_s (T - 20))
///     power = wall_share (friction x push x mean tooth speed + work x kerf x width x feed)
///
/// One lump of bone a cell, both walls of the kerf together; no heat flows from cell to cell.
/// source  docs/haptics.md, Heat, where each constant has its origin: several are fitted, none was
///         measured by us
#pragma once

#include "simulator/contact/tissue.h"

namespace hallux::simulator {

inline constexpr double body_celsius = 37.0;
inline constexpr double water_celsius = 20.0;
/// The model says nothing about bone that boils; the cap keeps the dose within what can be shown.
inline constexpr double ceiling_celsius = 120.0;
/// A minute of it is a dose of 16.
inline constexpr double hot_celsius = 47.0;
/// CEM43: minutes at 43 degrees that do the same.
inline constexpr double necrosis_dose_min = 16.0;

inline constexpr double saw_friction = 0.3;
inline constexpr double cortical_work_joule_per_mm3 = 0.6;
inline constexpr double cancellous_work_joule_per_mm3 = 0.05;
/// Of the heat stays in the walls; fitted.
inline constexpr double wall_share = 0.76;
inline constexpr double wall_depth_mm = 1.0;
/// How far behind the tooth line the blade rubs the walls warm.
inline constexpr double rubbing_length_mm = 2.0;
inline constexpr double bone_heat_joule_per_mm3_kelvin = 1950.0 * 1300.0 * 1.0e-9;
inline constexpr double cooling_s = 5.0;
inline constexpr double rinse_per_s = 2.76;
/// 4.5 degrees.
inline constexpr double saw_arc_rad = 0.0785398163397448310;

/// Over a whole swing to and fro of a blade that reaches so far from its pivot [mm/s].
double mean_tooth_speed_mm_s(double depth_mm, double cycles_per_minute) noexcept;

/// Work of taking away bone; 0 for what is no bone [J/mm3].
constexpr double cutting_work_joule_per_mm3(Tissue tissue) noexcept {
  if (tissue == Tissue::Cortical) return cortical_work_joule_per_mm3;
  return tissue == Tissue::Cancellous ? cancellous_work_joule_per_mm3 : 0.0;
}

/// How bone of both walls over one square millimetre of kerf cools during one span of time.
struct Cooling {
  double rate_per_s = 0.0;
  /// Of body and water together.
  double inflow_celsius_per_s = 0.0;
  /// Share of a difference that is left after the span.
  double decay = 1.0;
};
Cooling cooling_over(double span_s, bool is_rinsed) noexcept;

/// The temperature after the span under a steady heating; exact, so stable for any span, and capped
/// [degree Celsius].
double warmed_celsius(double from_celsius, double heating_celsius_per_s,
                      const Cooling& cooling) noexcept;

/// CEM43 minutes a minute at this temperature; 0 at 39 degrees and below, where a day does no harm.
/// source  Sapareto and Dewey 1984: R = 0.5 above 43 degrees, 0.25 below
double dose_rate(double celsius) noexcept;

}  // namespace hallux::simulator
