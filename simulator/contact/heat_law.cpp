#include "simulator/contact/heat_law.h"

#include <algorithm>

#include "simulator/base/elementary.h"

namespace hallux::simulator {

namespace {

constexpr double dose_begins_celsius = 39.0, dose_turns_celsius = 43.0;
constexpr double log_two = 0.693147180559945309;

}  // namespace

double mean_tooth_speed_mm_s(double depth_mm, double cycles_per_minute) noexcept {
  const double stroke_mm = 2.0 * depth_mm * elementary::sin(0.5 * saw_arc_rad);
  return 2.0 * stroke_mm * cycles_per_minute / 60.0;
}

Cooling cooling_over(double span_s, bool is_rinsed) noexcept {
  Cooling cooling{1.0 / cooling_s, body_celsius / cooling_s, 1.0};
  if (is_rinsed) {
    cooling.rate_per_s += rinse_per_s;
    cooling.inflow_celsius_per_s += rinse_per_s * water_celsius;
  }
  cooling.decay = elementary::exp(-cooling.rate_per_s * span_s);
  return cooling;
}

double warmed_celsius(double from_celsius, double heating_celsius_per_s,
                      const Cooling& cooling) noexcept {
  const double rest_celsius =
      (heating_celsius_per_s + cooling.inflow_celsius_per_s) / cooling.rate_per_s;
  return std::min(ceiling_celsius, rest_celsius + (from_celsius - rest_celsius) * cooling.decay);
}

double dose_rate(double celsius) noexcept {
  if (!(celsius > dose_begins_celsius)) return 0.0;
  const double over_celsius = celsius - dose_turns_celsius;
  return elementary::exp((over_celsius > 0.0 ? log_two : 2.0 * log_two) * over_celsius);
}

}  // namespace hallux::simulator
