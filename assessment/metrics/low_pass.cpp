#include "assessment/metrics/low_pass.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

/// One way through the filter.
class Way {
 public:
  /// From the state in which the first value has always been there.
  Way(const Recursion& filter, double first_value)
      : filter_(filter), second_((filter.b2 - filter.a2) * first_value) {
    first_ = (filter.b1 - filter.a1) * first_value + second_;
  }

  double passed(double given) noexcept {
    const double value = filter_.b0 * given + first_;
    first_ = filter_.b1 * given - filter_.a1 * value + second_;
    second_ = filter_.b2 * given - filter_.a2 * value;
    return value;
  }

 private:
  const Recursion& filter_;
  double first_ = 0.0, second_ = 0.0;
};

/// What goes on before the first value and after the last, each in the order of time.
struct Continued {
  std::vector<double> before, after;
};

Continued continued(std::span<const double> values, std::size_t beyond) {
  Continued made;
  for (std::size_t i = beyond; i > 0; --i) made.before.push_back(2.0 * values.front() - values[i]);
  for (std::size_t i = 1; i <= beyond; ++i)
    made.after.push_back(2.0 * values.back() - values[values.size() - 1 - i]);
  return made;
}

}  // namespace

void low_pass(std::span<double> values, const LowPass& filter) {
  if (values.empty()) return;
  const auto period = static_cast<std::size_t>(std::ceil(filter.rate_hz / filter.cutoff_hz));
  Continued beyond = continued(values, std::min(period, values.size() - 1));
  const Recursion recursion = butterworth(filter);
  Way forward(recursion, beyond.before.empty() ? values.front() : beyond.before.front());
  for (const double value : beyond.before) forward.passed(value);
  for (double& value : values) value = forward.passed(value);
  for (double& value : beyond.after) value = forward.passed(value);
  Way backward(recursion, beyond.after.empty() ? values.back() : beyond.after.back());
  for (auto value = beyond.after.rbegin(); value != beyond.after.rend(); ++value)
    backward.passed(*value);
  for (auto value = values.rbegin(); value != values.rend(); ++value)
    *value = backward.passed(*value);
}

}  // namespace hallux::assessment
