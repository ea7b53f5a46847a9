#include "assessment/metrics/smoothness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulator/base/units.h"

namespace hallux::assessment {
namespace {

constexpr double rate_hz = 1000.0;

/// The speed of a movement of least jerk that lasts `ticks` ms and goes up to `peak_mm_s`.
std::vector<double> least_jerk(std::size_t ticks, double peak_mm_s = 100.0) {
  std::vector<double> speeds_mm_s;
  for (std::size_t tick = 0; tick <= ticks; ++tick) {
    const double share = static_cast<double>(tick) / static_cast<double>(ticks);
    speeds_mm_s.push_back(peak_mm_s * 16.0 * share * share * (1.0 - share) * (1.0 - share));
  }
  return speeds_mm_s;
}

/// As many of them one after another.
std::vector<double> in_parts(int parts) {
  std::vector<double> speeds_mm_s;
  for (int part = 0; part < parts; ++part) {
    const std::vector<double> one = least_jerk(400);
    speeds_mm_s.insert(speeds_mm_s.end(), one.begin(), one.end());
  }
  return speeds_mm_s;
}

std::vector<double> times(double factor, std::vector<double> speeds_mm_s) {
  for (double& speed : speeds_mm_s) speed *= factor;
  return speeds_mm_s;
}

// 204.8 = 720 / (15 / 8)^2. The sum leaves out both ends, at which the second derivative is
// greatest: 5 of a thousand.
TEST(Ldlj, OfLeastJerkIsKnown) {
  EXPECT_NEAR(log_dimensionless_jerk(least_jerk(1000), rate_hz), -std::log(204.8), 0.006);
  EXPECT_NEAR(log_dimensionless_jerk(least_jerk(20000), rate_hz), -std::log(204.8), 0.0003);
}

TEST(Ldlj, IsTheDiscreteFormulaOfThePage) {
  const std::vector<double> speeds{5.0, 7.0, 12.0, 13.0, 9.0, 11.0, 6.0};
  // Second differences 3, -4, -5, 6, -7; over six spans of 10 ms, the peak 13.
  const double bends = 9.0 + 16.0 + 25.0 + 36.0 + 49.0;
  const double integral = bends / std::pow(0.01, 4) * 0.01;
  EXPECT_NEAR(log_dimensionless_jerk(speeds, 100.0),
              -std::log(std::pow(0.06, 3) / (13.0 * 13.0) * integral), 1e-12);
}

TEST(Ldlj, NeitherSizeNorRateChangesIt) {
  const std::vector<double> speeds = in_parts(2);
  const double one = log_dimensionless_jerk(speeds, rate_hz);
  EXPECT_NEAR(log_dimensionless_jerk(times(0.1, speeds), rate_hz), one, 1e-9);
  EXPECT_NEAR(log_dimensionless_jerk(speeds, 2.0 * rate_hz), one, 1e-9);
}

TEST(Ldlj, FallsAsSubMovementsAreAdded) {
  double before = 0.0;
  for (int parts = 1; parts <= 5; ++parts) {
    const double value = log_dimensionless_jerk(in_parts(parts), rate_hz);
    EXPECT_LT(value, before) << parts;
    before = value;
  }
}

/// The arc length by sines and cosines, from the words of the page.
double arc_length_of(const std::vector<double>& speeds) {
  std::size_t length = 1;
  while (length < 4 * speeds.size()) length *= 2;
  std::vector<double> sizes;
  for (std::size_t k = 0; static_cast<double>(k) * rate_hz <= 10.0 * static_cast<double>(length);
       ++k) {
    double in_phase = 0.0, out_of_phase = 0.0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const double turn = 2.0 * pi * static_cast<double>(k * i) / static_cast<double>(length);
      in_phase += speeds[i] * std::cos(turn);
      out_of_phase += speeds[i] * std::sin(turn);
    }
    sizes.push_back(std::sqrt(in_phase * in_phase + out_of_phase * out_of_phase));
  }
  std::size_t last = 0;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (sizes[k] >= 0.05 * sizes[0]) last = k;
  }
  double sum = 0.0;
  for (std::size_t k = 1; k <= last; ++k) {
    const double along = 1.0 / static_cast<double>(last);
    const double up = (sizes[k] - sizes[k - 1]) / sizes[0];
    sum += std::sqrt(along * along + up * up);
  }
  return -sum;
}

TEST(Sparc, IsTheFormulaOfThePage) {
  for (const std::vector<double>& speeds :
       {least_jerk(300), least_jerk(1000), in_parts(2), in_parts(5)})
    EXPECT_NEAR(spectral_arc_length(speeds, rate_hz), arc_length_of(speeds), 1e-9);
}

TEST(Sparc, SizeChangesNothing) {
  for (const int parts : {1, 3}) {
    const double one = spectral_arc_length(in_parts(parts), rate_hz);
    EXPECT_NEAR(spectral_arc_length(times(0.03, in_parts(parts)), rate_hz), one, 1e-9);
  }
}

// The spectrum's last frequency is one of a grid of about ten, so that a little changes with the
// duration.
TEST(Sparc, DurationChangesAlmostNothing) {
  const double one = spectral_arc_length(least_jerk(500), rate_hz);
  for (const std::size_t ticks : {400U, 800U, 1300U, 2000U})
    EXPECT_NEAR(spectral_arc_length(least_jerk(ticks), rate_hz), one, 0.05) << ticks;
}

TEST(Sparc, FallsAsSubMovementsAreAdded) {
  double before = 0.0;
  for (int parts = 1; parts <= 5; ++parts) {
    const double value = spectral_arc_length(in_parts(parts), rate_hz);
    EXPECT_LT(value, before - 0.1) << parts;
    before = value;
  }
}

}  // namespace
}  // namespace hallux::assessment
