#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "simulator/base/elementary.h"
#include "simulator/base/polynomial.h"

/// exp and log. Powers of two are taken off by the exponent bits, which is exact; what is left is
/// small enough for a series.
namespace hallux::elementary {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// ln 2 in 40 + 53 bits: a multiple below 2^13 of the first is exact.
constexpr double ln2_high = 0x1.62e42fefa2000p-1;
constexpr double ln2_low = 0x1.9ef35793c7673p-41;
constexpr double one_over_ln2 = 0x1.71547652b82fep+0;

/// 2^power, for -1022 <= power <= 1023.
double power_of_two(int power) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52U);
}

/// For -746 < x < 710.
double exponential(double x) noexcept {
  constexpr std::array<double, 12> series{1.0 / 2.0,        1.0 / 6.0,         1.0 / 24.0,
                                          1.0 / 120.0,      1.0 / 720.0,       1.0 / 5040.0,
                                          1.0 / 40320.0,    1.0 / 362880.0,    1.0 / 3628800.0,
                                          1.0 / 39916800.0, 1.0 / 479001600.0, 1.0 / 6227020800.0};
  const double doublings = std::floor(x * one_over_ln2 + 0.5);
  const double near = x - doublings * ln2_high;
  const double correction = 0.0 - doublings * ln2_low;
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

}  // namespace

double exp(double x) noexcept {
  if (!(x == x)) return nan_value;
  if (x > 709.782712893384) return infinity;
  if (x < -745.1332191019412) return 0.0;
  return exponential(x);
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

}  // namespace hallux::elementary
