/// A number that carries its gradient in space, so that a field and its slope come from one
/// formula. Inside this corner only.
#pragma once

#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/vector.h"

namespace hallux::scenarios {

struct Dual {
  double value = 0.0;
  Vec3 slope{0.0, 0.0, 0.0};
};

inline Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.slope + b.slope};
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.slope - b.slope};
}
inline Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
inline Dual operator+(const Dual& a, double b) { return {a.value + b, a.slope}; }
inline Dual operator-(const Dual& a, double b) { return {a.value - b, a.slope}; }
inline Dual operator*(const Dual& a, double b) { return {a.value * b, a.slope * b}; }
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.slope * b.value + b.slope * a.value};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.slope - b.slope * quotient) / b.value};
}
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, a.slope * (0.5 / root)};
}
inline Dual exp(const Dual& a) {
  const double power = elementary::exp(a.value);
  return {power, a.slope * power};
}
inline Dual max(const Dual& a, const Dual& b) { return a.value >= b.value ? a : b; }

/// base ^ exponent; 0 with slope 0 where the base is not above 1e-12.
/// needs   exponent.value > 1, or a base well above 0
inline Dual pow(const Dual& base, const Dual& exponent) {
  if (!(base.value > 1e-12)) return {};
  const double log_base = elementary::log(base.value);
  const double power = elementary::exp(exponent.value * log_base);
  return {power, (base.slope * (exponent.value / base.value) + exponent.slope * log_base) * power};
}

/// The greater of two, rounded within `blend` of where they are equal; never below the greater.
inline Dual smooth_max(const Dual& a, const Dual& b, double blend) {
  const double apart = std::abs(a.value - b.value);
  const Dual greater = max(a, b);
  if (apart >= blend) return greater;
  const double h = (blend - apart) / blend;
  const Dual& lesser = a.value >= b.value ? b : a;
  const double share = 0.5 * h;
  return {greater.value + 0.25 * h * h * blend,
          greater.slope * (1.0 - share) + lesser.slope * share};
}
inline Dual smooth_min(const Dual& a, const Dual& b, double blend) {
  return -smooth_max(-a, -b, blend);
}

/// 0 below `low`, 1 above `high`, 3t^2 - 2t^3 between.
inline double smooth_step(double low, double high, double value) {
  const double t = (value - low) / (high - low);
  if (t <= 0.0) return 0.0;
  if (t >= 1.0) return 1.0;
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace hallux::scenarios
