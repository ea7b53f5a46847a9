#include "simulator/base/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hallux {
namespace {

/// The first numbers of SplitMix64 from seed 0, as in its authors' reference.
TEST(Random, IsSplitMix64) {
  Random random{0};
  EXPECT_EQ(random.bits(), 0xE220A8397B1DCDAFULL);
  EXPECT_EQ(random.bits(), 0x6E789E6AA1B965F4ULL);
}

TEST(Random, TheSameSeedGivesTheSameNumbers) {
  Random one{42};
  Random other{42};
  for (int i = 0; i < 100; ++i) EXPECT_EQ(one.bits(), other.bits());
}

TEST(Random, AStreamIsNamedByItsSeedAndNameAlone) {
  Random first{7, "tremor"};
  Random other{7, "angle"};
  for (int i = 0; i < 10; ++i) other.bits();
  Random again{7, "tremor"};
  const std::uint64_t bits = first.bits();
  EXPECT_EQ(bits, again.bits());
  EXPECT_NE(bits, Random(7, "angle").bits());
  EXPECT_NE(bits, Random(8, "tremor").bits());
}

TEST(Random, UniformStaysInItsHalfOpenInterval) {
  Random random{3};
  double sum = 0.0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double value = random.uniform(-2.0, 4.0);
    ASSERT_GE(value, -2.0);
    ASSERT_LT(value, 4.0);
    sum += value;
  }
  // Five standard errors: 6 / sqrt(12) / sqrt(count).
  EXPECT_NEAR(sum / count, 1.0, 5.0 * 6.0 / std::sqrt(12.0 * count));
}

TEST(Random, NormalHasMeanZeroAndDeviationOne) {
  Random random{4};
  double sum = 0.0;
  double squares = 0.0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double value = random.normal();
    sum += value;
    squares += value * value;
  }
  // Five standard errors of the mean and of the variance.
  EXPECT_NEAR(sum / count, 0.0, 5.0 / std::sqrt(static_cast<double>(count)));
  EXPECT_NEAR(squares / count, 1.0, 5.0 * std::sqrt(2.0 / count));
}

TEST(Random, TruncatedNormalStaysWithinItsLimit) {
  Random random{5};
  for (int i = 0; i < 5000; ++i) {
    const double value = random.truncated_normal(10.0, 2.0, 1.5);
    ASSERT_GE(value, 7.0);
    ASSERT_LE(value, 13.0);
  }
}

}  // namespace
}  // namespace hallux
