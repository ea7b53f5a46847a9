/// From a metric to points, in integer thousandths. Inside this corner only.
#pragma once

#include <cstdint>

#include "scenarios/scenario.h"

namespace hallux::assessment {

/// Where the points of one metric begin and end.
struct Band {
  double zero_low = 0.0, full_low = 0.0, full_high = 0.0, zero_high = 0.0;
};

/// All of the weight up to `full`, none from `zero` on, linear between, rounded to the nearest
/// thousandth. With `full` above `zero` higher is better. A value that is not a number earns
/// nothing.
/// ensures the result lies in [0, weight_milli] and never falls as the value moves towards `full`
/// source  docs/metrics.md, "From a metric to points"
std::int64_t lower_points_milli(double value, double full, double zero,
                                std::int64_t weight_milli) noexcept;
/// All of the weight inside [full_low, full_high], none outside (zero_low, zero_high), linear
/// between.
std::int64_t band_points_milli(double value, const Band& band, std::int64_t weight_milli) noexcept;

/// The points that a rubric item gives for this value.
std::int64_t points_milli(const scenarios::RubricItem& item, double value) noexcept;

}  // namespace hallux::assessment
