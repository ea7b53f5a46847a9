#include "assessment/metrics/low_pass.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

/// The filter as a recursion of second order, in transposed direct form.
struct Recursion {
  double b0 = 1.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;
};

/// By the bilinear transform, with the cut-off kept where it is.
Recursion butterworth(const LowPass& filter) {
  const double warped = std::tan(pi * filter.cutoff_hz / filter.rate_hz);
  const double squared = warped * warped;
  const double scale = 1.0 / (1.0 + std::sqrt(2.0) * warped + squared);
  return {.b0 = squared * scale,
          .b1 = 2.0 * squared * scale,
          .b2 = squared * scale,
          .a1 = 2.0 * (squared - 1.0) * scale,
          .a2 = (1.0 - std::sqrt(2.0) * warped + squared) * scale};
}

/// From the state in which the first value has always been there.
void run(const Recursion& filter, std::vector<double>& values) {
  double second = (filter.b2 - filter.a2) * values.front();
  double first = (filter.b1 - filter.a1) * values.front() + second;
  for (double& value : values) {
    const double given = value;
    value = filter.b0 * given + first;
    first = filter.b1 * given - filter.a1 * value + second;
    second = filter.b2 * given - filter.a2 * value;
  }
}

std::vector<double> continued(std::span<const double> values, std::size_t beyond) {
  std::vector<double> longer;
  longer.reserve(values.size() + 2 * beyond);
  for (std::size_t i = beyond; i > 0; --i) longer.push_back(2.0 * values.front() - values[i]);
  longer.insert(longer.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= beyond; ++i)
    longer.push_back(2.0 * values.back() - values[values.size() - 1 - i]);
  return longer;
}

}  // namespace

std::vector<double> low_passed(std::span<const double> values, const LowPass& filter) {
  if (values.empty()) return {};
  const auto period = static_cast<std::size_t>(std::ceil(filter.rate_hz / filter.cutoff_hz));
  const std::size_t beyond = std::min(period, values.size() - 1);
  std::vector<double> passed = continued(values, beyond);
  const Recursion recursion = butterworth(filter);
  run(recursion, passed);
  std::reverse(passed.begin(), passed.end());
  run(recursion, passed);
  std::reverse(passed.begin(), passed.end());
  const auto first = passed.begin() + static_cast<std::ptrdiff_t>(beyond);
  return {first, first + static_cast<std::ptrdiff_t>(values.size())};
}

}  // namespace hallux::assessment
