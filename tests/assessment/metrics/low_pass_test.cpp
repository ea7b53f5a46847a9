#include "assessment/metrics/low_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "simulator/base/units.h"

namespace hallux::assessment {
namespace {

constexpr LowPass filter{};

std::vector<double> low_passed(std::vector<double> values, const LowPass& by) {
  low_pass(values, by);
  return values;
}

std::vector<double> sine(double frequency_hz, std::size_t count, double rate_hz = filter.rate_hz) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::sin(2.0 * pi * frequency_hz * static_cast<double>(i) / rate_hz));
  return values;
}

TEST(LowPass, AConstantPassesUnchanged) {
  for (const std::size_t count : {1U, 2U, 50U, 1000U}) {
    const std::vector<double> passed = low_passed(std::vector<double>(count, -3.7), filter);
    ASSERT_EQ(passed.size(), count);
    for (const double value : passed) EXPECT_NEAR(value, -3.7, 1e-12);
  }
  EXPECT_TRUE(low_passed({}, filter).empty());
}

// It begins at rest a period before the first value, and is 22.5 samples behind where it never
// rested: of that, e^-4.4 x sqrt(2) is left at the first value.
TEST(LowPass, AStraightLinePassesUnchangedOnceItHasRunIn) {
  std::vector<double> line;
  line.reserve(2000);
  for (int i = 0; i < 2000; ++i) line.push_back(5.0 + 0.03 * i);
  const std::vector<double> passed = low_passed(line, filter);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool has_run_in = i >= 400 && i < 1600;
    EXPECT_NEAR(passed[i], line[i], has_run_in ? 1e-6 : 0.02 * 22.5 * 0.03) << i;
  }
}

// Each way takes 1 / sqrt(1 + (f / f_c)^4), with both frequencies bent by the bilinear transform.
TEST(LowPass, ASineKeepsItsPhaseAndTheShareOfBothPasses) {
  for (const double frequency_hz : {1.0, 5.0, 10.0, 20.0, 100.0}) {
    const double bent = std::tan(pi * frequency_hz / filter.rate_hz) /
                        std::tan(pi * filter.cutoff_hz / filter.rate_hz);
    const double gain = 1.0 / (1.0 + std::pow(bent, 4.0));
    const std::vector<double> given = sine(frequency_hz, 4000);
    const std::vector<double> passed = low_passed(given, filter);
    for (std::size_t i = 1500; i < 2500; ++i)
      EXPECT_NEAR(passed[i], gain * given[i], 1e-9) << frequency_hz << " Hz at " << i;
  }
}

TEST(LowPass, ASineAtTheCutOffComesOutWithHalfItsSize) {
  for (const LowPass& each : {LowPass{10.0, 1000.0}, LowPass{25.0, 200.0}}) {
    const std::vector<double> given = sine(each.cutoff_hz, 4000, each.rate_hz);
    const std::vector<double> passed = low_passed(given, each);
    for (std::size_t i = 1900; i < 2100; ++i) EXPECT_NEAR(passed[i], 0.5 * given[i], 1e-9);
  }
}

TEST(LowPass, TheSameBackwardsComesOutBackwards) {
  std::vector<double> values = sine(3.0, 700);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.001 * static_cast<double>(i * i);
  std::vector<double> reversed = values;
  std::reverse(reversed.begin(), reversed.end());
  const std::vector<double> passed = low_passed(values, filter);
  std::vector<double> back = low_passed(reversed, filter);
  std::reverse(back.begin(), back.end());
  // Forward first and backward first differ by what has not run out at the ends.
  for (std::size_t i = 300; i < 400; ++i) EXPECT_NEAR(passed[i], back[i], 1e-3);
}

TEST(LowPass, AStepIsSharedEvenlyByBothOfItsSides) {
  std::vector<double> values(2001, 0.0);
  for (std::size_t i = 1001; i < values.size(); ++i) values[i] = 1.0;
  values[1000] = 0.5;
  const std::vector<double> passed = low_passed(values, filter);
  EXPECT_NEAR(passed[1000], 0.5, 1e-9);
  for (std::size_t i = 1; i < 200; ++i) EXPECT_NEAR(passed[1000 + i] + passed[1000 - i], 1.0, 1e-9);
}

}  // namespace
}  // namespace hallux::assessment
