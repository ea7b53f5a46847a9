#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "simulator/base/elementary.h"

/// exp, log and pow. Powers of two are taken off by the exponent bits, which is exact; what is left
/// is small enough for a series. pow carries the logarithm as a sum of two numbers, because the
/// product with the exponent magnifies its error by up to 709.
namespace hallux::elementary {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// ln 2 in 40 + 53 bits: a multiple below 2^13 of the first is exact.
constexpr double ln2_high = 0x1.62e42fefa2000p-1;
constexpr double ln2_low = 0x1.9ef35793c7673p-41;
constexpr double one_over_ln2 = 0x1.71547652b82fep+0;

struct Sum {
  double high = 0.0;
  double low = 0.0;
};

/// a + b without loss (Knuth).
Sum exact_sum(double a, double b) noexcept {
  const double high = a + b;
  const double b_seen = high - a;
  return {high, (a - (high - b_seen)) + (b - b_seen)};
}

/// a * b without loss and without a fused multiply-add (Dekker 1971); needs |a|, |b| < 2^996.
Sum exact_product(double a, double b) noexcept {
  constexpr double splitter = 134217729.0;
  const double a_scaled = splitter * a;
  const double b_scaled = splitter * b;
  const double a_high = a_scaled - (a_scaled - a);
  const double b_high = b_scaled - (b_scaled - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double high = a * b;
  return {high, ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// 2^power, for -1022 <= power <= 1023.
double power_of_two(int power) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52U);
}

template <std::size_t Count>
double polynomial(const std::array<double, Count>& coefficients, double x) noexcept {
  double value = coefficients[Count - 1];
  for (std::size_t i = Count - 1; i-- > 0;) value = value * x + coefficients[i];
  return value;
}

/// exp(x.high + x.low) for -746 < x.high < 710.
double exponential(const Sum& x) noexcept {
  constexpr std::array<double, 12> series{1.0 / 2.0,        1.0 / 6.0,         1.0 / 24.0,
                                          1.0 / 120.0,      1.0 / 720.0,       1.0 / 5040.0,
                                          1.0 / 40320.0,    1.0 / 362880.0,    1.0 / 3628800.0,
                                          1.0 / 39916800.0, 1.0 / 479001600.0, 1.0 / 6227020800.0};
  const double doublings = std::floor(x.high * one_over_ln2 + 0.5);
  const double near = x.high - doublings * ln2_high;
  const double correction = x.low - doublings * ln2_low;
  const double rest = near + correction;
  const double lost = (near - rest) + correction;
  const double value = 1.0 + (rest + (lost + rest * rest * polynomial(series, rest)));
  // In two factors, because 2^1024 and the powers below 2^-1022 are no numbers of their own.
  const int power = static_cast<int>(doublings);
  const int half = power / 2;
  return value * power_of_two(half) * power_of_two(power - half);
}

struct Scaled {
  double fraction = 1.0;  ///< in [sqrt(1/2), sqrt(2))
  double power = 0.0;     ///< x = fraction * 2^power
};

/// needs   x > 0 and finite
Scaled scale(double x) noexcept {
  double power = 0.0;
  if (x < 0x1.0p-1022) {
    x *= 0x1.0p54;
    power = -54.0;
  }
  auto bits = std::bit_cast<std::uint64_t>(x);
  const auto exponent = static_cast<int>(bits >> 52U) - 1023;
  bits = (bits & 0x000FFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL;
  const double fraction = std::bit_cast<double>(bits);
  power += static_cast<double>(exponent);
  if (fraction >= 0x1.6a09e667f3bcdp+0) return {0.5 * fraction, power + 1.0};
  return {fraction, power};
}

/// (2 artanh(s) - 2 s) / s as a function of s^2.
double artanh_tail(double square) noexcept {
  constexpr std::array<double, 11> series{2.0 / 3.0,  2.0 / 5.0,  2.0 / 7.0,  2.0 / 9.0,
                                          2.0 / 11.0, 2.0 / 13.0, 2.0 / 15.0, 2.0 / 17.0,
                                          2.0 / 19.0, 2.0 / 21.0, 2.0 / 23.0};
  return square * polynomial(series, square);
}

/// The logarithm as a sum that is good to about 1e-18 of its size: log(1 + f) = 2 artanh(f / (2 +
/// f)).
Sum exact_logarithm(double x) noexcept {
  const Scaled scaled = scale(x);
  const double f = scaled.fraction - 1.0;
  const Sum divisor = exact_sum(2.0, f);
  const double s = f / divisor.high;
  const Sum back = exact_product(s, divisor.high);
  const double s_low = (((f - back.high) - back.low) - s * divisor.low) / divisor.high;
  const Sum head = exact_sum(scaled.power * ln2_high, 2.0 * s);
  const double tail = s * artanh_tail(s * s) + (2.0 * s_low + scaled.power * ln2_low);
  const double low = head.low + tail;
  const double high = head.high + low;
  return {high, (head.high - high) + low};
}

/// pow where a zero, an infinity or a NaN takes part.
double power_at_the_edges(double base, double exponent) noexcept {
  if (!(base >= 0.0) || !(exponent == exponent)) return nan_value;
  const bool is_growing = (base > 1.0) == (exponent > 0.0);
  return is_growing ? infinity : 0.0;
}

}  // namespace

double exp(double x) noexcept {
  if (!(x == x)) return nan_value;
  if (x > 709.782712893384) return infinity;
  if (x < -745.1332191019412) return 0.0;
  return exponential({x, 0.0});
}

double log(double x) noexcept {
  if (!(x >= 0.0)) return nan_value;
  if (x == 0.0) return -infinity;
  if (x == infinity) return infinity;
  const Scaled scaled = scale(x);
  const double f = scaled.fraction - 1.0;
  const double s = f / (2.0 + f);
  const double half_square = 0.5 * f * f;
  const double small = s * (half_square + artanh_tail(s * s)) + scaled.power * ln2_low;
  return scaled.power * ln2_high - ((half_square - small) - f);
}

double pow(double base, double exponent) noexcept {
  if (exponent == 0.0 || base == 1.0) return 1.0;
  const bool is_ordinary = base > 0.0 && base < infinity && exponent - exponent == 0.0;
  if (!is_ordinary) return power_at_the_edges(base, exponent);
  const Sum logarithm = exact_logarithm(base);
  const double estimate = exponent * logarithm.high;
  if (estimate > 709.79) return infinity;
  if (estimate < -745.14) return 0.0;
  const Sum product = exact_product(exponent, logarithm.high);
  return exponential({product.high, product.low + exponent * logarithm.low});
}

}  // namespace hallux::elementary
