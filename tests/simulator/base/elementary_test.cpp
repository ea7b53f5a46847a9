#include "simulator/base/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simulator/base/random.h"
#include "simulator/base/units.h"

/// libm is the judge: it is within one unit in the last place, so 1e-15 leaves our functions about
/// three such units.
namespace hallux {
namespace {

constexpr double accuracy = 1.0e-15;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double relative_error(double value, double expected) {
  if (value == expected) return 0.0;
  return std::fabs(value - expected) / std::fabs(expected);
}

TEST(Elementary, SineAndCosineAgreeWithLibm) {
  Random random{1};
  for (int i = 0; i < 40000; ++i) {
    const double x = i % 2 == 0 ? random.uniform(-1.0e5, 1.0e5) : random.uniform(-8.0, 8.0);
    ASSERT_NEAR(elementary::sin(x), std::sin(x), accuracy) << x;
    ASSERT_NEAR(elementary::cos(x), std::cos(x), accuracy) << x;
    ASSERT_LE(relative_error(elementary::sin(x), std::sin(x)), accuracy) << x;
  }
}

TEST(Elementary, SineStaysExactBesideMultiplesOfAQuarterTurn) {
  for (int i = -63000; i <= 63000; i += 7) {
    const double x = static_cast<double>(i) * (0.5 * pi);
    ASSERT_LE(relative_error(elementary::sin(x), std::sin(x)), accuracy) << i;
    ASSERT_LE(relative_error(elementary::cos(x), std::cos(x)), accuracy) << i;
  }
  EXPECT_EQ(elementary::sin(0.0), 0.0);
  EXPECT_EQ(elementary::cos(0.0), 1.0);
  EXPECT_EQ(elementary::sin(1.0e-300), 1.0e-300);
}

TEST(Elementary, SineBeyondItsDomainIsNotANumber) {
  for (const double x : {1.1e5, -1.1e5, infinity, -infinity, not_a_number}) {
    EXPECT_TRUE(std::isnan(elementary::sin(x))) << x;
    EXPECT_TRUE(std::isnan(elementary::cos(x))) << x;
  }
}

TEST(Elementary, ArcTangentAgreesWithLibmInAllQuadrants) {
  Random random{2};
  for (int i = 0; i < 40000; ++i) {
    const double scale = elementary::exp(random.uniform(-40.0, 40.0));
    const double y = random.uniform(-1.0, 1.0);
    const double x = random.uniform(-1.0, 1.0) * (i % 2 == 0 ? 1.0 : scale);
    ASSERT_LE(relative_error(elementary::atan2(y, x), std::atan2(y, x)), accuracy) << y << " " << x;
  }
}

TEST(Elementary, ArcTangentKnowsTheAxes) {
  EXPECT_EQ(elementary::atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(elementary::atan2(0.0, 1.0), 0.0);
  EXPECT_EQ(elementary::atan2(0.0, -1.0), pi);
  EXPECT_EQ(elementary::atan2(-0.0, -1.0), pi);
  EXPECT_EQ(elementary::atan2(1.0, 0.0), 0.5 * pi);
  EXPECT_EQ(elementary::atan2(-1.0, 0.0), -0.5 * pi);
  EXPECT_EQ(elementary::atan2(infinity, infinity), 0.25 * pi);
  EXPECT_EQ(elementary::atan2(1.0, infinity), 0.0);
  EXPECT_EQ(elementary::atan2(1.0e-310, 1.0e-310), 0.25 * pi);
  EXPECT_EQ(elementary::atan2(1.0e308, 1.0e308), 0.25 * pi);
  EXPECT_TRUE(std::isnan(elementary::atan2(not_a_number, 1.0)));
}

TEST(Elementary, ArcSineAgreesWithLibm) {
  Random random{3};
  for (int i = 0; i < 40000; ++i) {
    const double near_end = 1.0 - elementary::exp(random.uniform(-36.0, 0.0));
    const double x = (i % 2 == 0 ? near_end : random.uniform()) * (i % 4 < 2 ? 1.0 : -1.0);
    ASSERT_LE(relative_error(elementary::asin(x), std::asin(x)), accuracy) << x;
  }
  EXPECT_EQ(elementary::asin(2.0), 0.5 * pi);
  EXPECT_TRUE(std::isnan(elementary::asin(not_a_number)));
}

TEST(Elementary, ExponentialAgreesWithLibm) {
  Random random{4};
  for (int i = 0; i < 40000; ++i) {
    const double x = i % 2 == 0 ? random.uniform(-708.0, 709.7) : random.uniform(-1.0, 1.0);
    ASSERT_LE(relative_error(elementary::exp(x), std::exp(x)), accuracy) << x;
  }
  EXPECT_EQ(elementary::exp(0.0), 1.0);
  EXPECT_EQ(elementary::exp(710.0), infinity);
  EXPECT_EQ(elementary::exp(-746.0), 0.0);
  EXPECT_EQ(elementary::exp(infinity), infinity);
  EXPECT_EQ(elementary::exp(-infinity), 0.0);
  EXPECT_TRUE(std::isnan(elementary::exp(not_a_number)));
}

TEST(Elementary, ExponentialOfSubnormalSizeIsWithinTheLastPlace) {
  Random random{5};
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-745.0, -708.0);
    ASSERT_NEAR(elementary::exp(x), std::exp(x), 5.0e-324 + accuracy * std::exp(x)) << x;
  }
}

TEST(Elementary, LogarithmAgreesWithLibm) {
  Random random{6};
  for (int i = 0; i < 40000; ++i) {
    const double beside_one =
        1.0 + random.uniform(-0.3, 0.4) * elementary::exp(random.uniform(-30.0, 0.0));
    const double x = i % 2 == 0 ? elementary::exp(random.uniform(-740.0, 709.0)) : beside_one;
    ASSERT_LE(relative_error(elementary::log(x), std::log(x)), accuracy) << x;
  }
  EXPECT_EQ(elementary::log(1.0), 0.0);
  EXPECT_EQ(elementary::log(0.0), -infinity);
  EXPECT_EQ(elementary::log(infinity), infinity);
  EXPECT_TRUE(std::isnan(elementary::log(-1.0)));
  EXPECT_TRUE(std::isnan(elementary::log(not_a_number)));
}

/// These bits are the promise itself: the same on every machine and with every compiler.
TEST(Elementary, GivesTheseBitsEverywhere) {
  EXPECT_EQ(elementary::sin(1.0), 0x1.aed548f090ceep-1);
  EXPECT_EQ(elementary::cos(1.0), 0x1.14a280fb5068cp-1);
  EXPECT_EQ(elementary::exp(1.0), 0x1.5bf0a8b14576ap+1);
  EXPECT_EQ(elementary::log(10.0), 0x1.26bb1bbb55516p+1);
  EXPECT_EQ(elementary::atan2(1.0, 3.0), 0x1.4978fa3269ee1p-2);
}

}  // namespace
}  // namespace hallux
