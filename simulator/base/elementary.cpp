#include "simulator/base/elementary.h"

#include <array>
#include <cmath>
#include <limits>

#include "simulator/base/polynomial.h"

/// The functions of angles. An argument is first brought near zero by subtracting a multiple of a
/// constant written as a sum of parts (Cody and Waite 1980): the leading parts have so few bits
/// that their product with the multiple is exact. What is left is small enough for the Taylor
/// series, whose first term left out is below 1e-17 of the result.
namespace hallux::elementary {

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

/// A number as the unevaluated sum of a leading part and a correction below half its last place.
struct Sum {
  double high = 0.0;
  double low = 0.0;
};

// pi/2 in 33 + 33 + 33 + 53 bits; a multiple below 2^20 of one of the first three is exact.
constexpr double half_pi_1 = 0x1.921fb54400000p+0;
constexpr double half_pi_2 = 0x1.0b4611a600000p-34;
constexpr double half_pi_3 = 0x1.3198a2e000000p-69;
constexpr double half_pi_4 = 0x1.b839a252049c1p-104;
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;

constexpr Sum half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr Sum whole_pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// a - b without loss (Knuth).
Sum exact_difference(double a, double b) noexcept {
  const double high = a - b;
  const double b_seen = a - high;
  return {high, (a - (high + b_seen)) + (b_seen - b)};
}

struct Reduced {
  Sum angle_rad;  ///< in [-pi/4, pi/4], as a sum
  int quadrant = 0;
};

Reduced reduce(double x) noexcept {
  const double turns = std::floor(x * two_over_pi + 0.5);
  const Sum first = exact_difference(x - turns * half_pi_1, turns * half_pi_2);
  const Sum second = exact_difference(first.high, turns * half_pi_3);
  const double low = (first.low + second.low) - turns * half_pi_4;
  const double high = second.high + low;
  const int quadrant = static_cast<int>(turns) & 3;
  return {{high, (second.high - high) + low}, quadrant};
}

double sine_near_zero(const Sum& angle) noexcept {
  constexpr std::array<double, 8> series{
      -1.0 / 6.0,        1.0 / 120.0,        -1.0 / 5040.0,          1.0 / 362880.0,
      -1.0 / 39916800.0, 1.0 / 6227020800.0, -1.0 / 1307674368000.0, 1.0 / 355687428096000.0};
  const double square = angle.high * angle.high;
  const double rest = angle.high * (square * polynomial(series, square));
  return angle.high + (rest + angle.low * (1.0 - 0.5 * square));
}

double cosine_near_zero(const Sum& angle) noexcept {
  constexpr std::array<double, 7> series{
      1.0 / 24.0,        -1.0 / 720.0,         1.0 / 40320.0,         -1.0 / 3628800.0,
      1.0 / 479001600.0, -1.0 / 87178291200.0, 1.0 / 20922789888000.0};
  const double square = angle.high * angle.high;
  const double half = 0.5 * square;
  const double near_one = 1.0 - half;
  const double rest = square * square * polynomial(series, square) - angle.high * angle.low;
  return near_one + (((1.0 - near_one) - half) + rest);
}

/// Sine of the angle plus `quarters` quarter turns.
double sine_shifted(double x, int quarters) noexcept {
  if (!(x >= -1.0e5 && x <= 1.0e5)) return nan_value;
  const Reduced reduced = reduce(x);
  const int quadrant = (reduced.quadrant + quarters) & 3;
  const double value =
      (quadrant & 1) != 0 ? cosine_near_zero(reduced.angle_rad) : sine_near_zero(reduced.angle_rad);
  return (quadrant & 2) != 0 ? -value : value;
}

/// atan(ratio) for a ratio in [0, 1]: atan(c) + atan((ratio - c) / (1 + c ratio)) with c the
/// nearest quarter.
Sum arc_tangent(double ratio) noexcept {
  constexpr std::array<Sum, 5> known{{{0.0, 0.0},
                                      {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                      {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                      {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                      {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};
  constexpr std::array<double, 9> series{-1.0 / 3.0,  1.0 / 5.0,   -1.0 / 7.0,
                                         1.0 / 9.0,   -1.0 / 11.0, 1.0 / 13.0,
                                         -1.0 / 15.0, 1.0 / 17.0,  -1.0 / 19.0};
  const double quarters = std::floor(4.0 * ratio + 0.5);
  const double near = 0.25 * quarters;
  const double rest = (ratio - near) / (1.0 + near * ratio);
  const double square = rest * rest;
  const Sum& base = known[static_cast<std::size_t>(quarters)];
  const double small = rest * (square * polynomial(series, square));
  const double high = base.high + rest;
  return {high, ((base.high - high) + rest) + (small + base.low)};
}

}  // namespace

double sin(double x) noexcept { return sine_shifted(x, 0); }

double cos(double x) noexcept { return sine_shifted(x, 1); }

double atan2(double y, double x) noexcept {
  if (!(x == x) || !(y == y)) return nan_value;
  const double across = std::fabs(y);
  const double along = std::fabs(x);
  const bool is_steep = across > along;
  const double larger = is_steep ? across : along;
  const double smaller = is_steep ? along : across;
  const bool both_infinite = smaller > std::numeric_limits<double>::max();
  if (larger == 0.0) return 0.0;
  Sum angle = arc_tangent(both_infinite ? 1.0 : smaller / larger);
  if (is_steep) {
    const Sum turned = exact_difference(half_pi.high, angle.high);
    angle = {turned.high, turned.low + (half_pi.low - angle.low)};
  }
  if (x < 0.0) {
    const Sum turned = exact_difference(whole_pi.high, angle.high);
    angle = {turned.high, turned.low + (whole_pi.low - angle.low)};
  }
  const double value = angle.high + angle.low;
  return y < 0.0 ? -value : value;
}

double asin(double x) noexcept {
  const double clamped = x > 1.0 ? 1.0 : (x < -1.0 ? -1.0 : x);
  return atan2(clamped, std::sqrt((1.0 - clamped) * (1.0 + clamped)));
}

}  // namespace hallux::elementary
