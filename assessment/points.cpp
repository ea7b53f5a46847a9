#include "assessment/points.h"

#include <algorithm>
#include <cmath>

namespace hallux::assessment {

namespace {

/// Where the value stands between the end that earns nothing and the one that earns all.
double ramp(double value, double zero, double full) noexcept {
  if (zero == full) return value == full ? 1.0 : 0.0;
  return std::clamp((zero - value) / (zero - full), 0.0, 1.0);
}

std::int64_t share_milli(double fraction, std::int64_t weight_milli) noexcept {
  return std::llround(fraction * static_cast<double>(weight_milli));
}

}  // namespace

std::int64_t lower_points_milli(double value, double full, double zero,
                                std::int64_t weight_milli) noexcept {
  if (std::isnan(value)) return 0;
  // Equal ends make a step: up to it everything, beyond it nothing.
  if (full == zero) return value <= full ? weight_milli : 0;
  return share_milli(ramp(value, zero, full), weight_milli);
}

std::int64_t band_points_milli(double value, const Band& band, std::int64_t weight_milli) noexcept {
  if (std::isnan(value)) return 0;
  if (value >= band.full_low && value <= band.full_high) return weight_milli;
  const double fraction = value < band.full_low ? ramp(value, band.zero_low, band.full_low)
                                                : ramp(value, band.zero_high, band.full_high);
  return share_milli(fraction, weight_milli);
}

std::int64_t points_milli(const scenarios::RubricItem& item, double value) noexcept {
  if (!item.is_band) return lower_points_milli(value, item.full, item.zero, item.weight_milli);
  return band_points_milli(value, {item.zero_low, item.full_low, item.full_high, item.zero_high},
                           item.weight_milli);
}

}  // namespace hallux::assessment
