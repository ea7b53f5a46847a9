#include "simulator/base/time_spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "simulator/base/random.h"

namespace hallux {
namespace {

using std::chrono::nanoseconds;

TEST(TimeSpread, OfNothingIsZero) {
  const TimeSpread spread;
  EXPECT_EQ(spread.at_us(0.5), 0.0);
  EXPECT_EQ(spread.greatest_us(), 0.0);
}

TEST(TimeSpread, TellsShortTimesExactly) {
  TimeSpread spread;
  for (int time_ns = 1; time_ns <= 101; ++time_ns) spread.add(nanoseconds(time_ns));
  EXPECT_DOUBLE_EQ(spread.at_us(0.0), 0.001);
  EXPECT_DOUBLE_EQ(spread.at_us(0.5), 0.051);
  EXPECT_DOUBLE_EQ(spread.at_us(1.0), 0.101);
}

TEST(TimeSpread, IsAsNearToSortedTimesAsItSays) {
  Random random(5);
  TimeSpread spread;
  std::vector<std::int64_t> times_ns;
  for (int i = 0; i < 20000; ++i) {
    // From half a microsecond to half a second, as many in each doubling.
    const double scale = static_cast<double>(std::int64_t{1} << (random.bits() % 20U));
    times_ns.push_back(static_cast<std::int64_t>(500.0 * scale * random.uniform(1.0, 2.0)));
    spread.add(nanoseconds(times_ns.back()));
  }
  std::sort(times_ns.begin(), times_ns.end());
  for (const double share : {0.0, 0.01, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(times_ns.size() - 1));
    const double exact_us = 1.0e-3 * static_cast<double>(times_ns[place]);
    EXPECT_NEAR(spread.at_us(share), exact_us, exact_us / 500.0) << share;
  }
  EXPECT_DOUBLE_EQ(spread.greatest_us(), 1.0e-3 * static_cast<double>(times_ns.back()));
}

TEST(TimeSpread, TakesTimesThatNoLoopHas) {
  TimeSpread spread;
  spread.add(nanoseconds(-5));
  spread.add(std::chrono::hours(1000));
  EXPECT_EQ(spread.at_us(0.0), 0.0);
  EXPECT_GT(spread.at_us(1.0), 1.0e9);
  EXPECT_DOUBLE_EQ(spread.greatest_us(), 3.6e12);
}

}  // namespace
}  // namespace hallux
