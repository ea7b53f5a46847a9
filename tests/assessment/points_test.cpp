#include "assessment/points.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace hallux::assessment {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(Points, AllUpToFullNoneFromZeroOnAndLinearBetween) {
  EXPECT_EQ(lower_points_milli(0.0, 1.0, 8.0, 16000), 16000);
  EXPECT_EQ(lower_points_milli(1.0, 1.0, 8.0, 16000), 16000);
  EXPECT_EQ(lower_points_milli(4.5, 1.0, 8.0, 16000), 8000);
  EXPECT_EQ(lower_points_milli(8.0, 1.0, 8.0, 16000), 0);
  EXPECT_EQ(lower_points_milli(90.0, 1.0, 8.0, 16000), 0);
}

TEST(Points, WithFullAboveZeroHigherIsBetter) {
  EXPECT_EQ(lower_points_milli(4.0, 4.0, 2.0, 3000), 3000);
  EXPECT_EQ(lower_points_milli(3.0, 4.0, 2.0, 3000), 1500);
  EXPECT_EQ(lower_points_milli(1.0, 4.0, 2.0, 3000), 0);
}

TEST(Points, EqualEndsMakeAStep) {
  EXPECT_EQ(lower_points_milli(2.0, 2.0, 2.0, 1000), 1000);
  EXPECT_EQ(lower_points_milli(2.000001, 2.0, 2.0, 1000), 0);
}

TEST(Points, ABandPaysInsideAndRampsOnBothSides) {
  const Band hinge{0.0, 0.8, 2.0, 3.5};
  EXPECT_EQ(band_points_milli(1.1, hinge, 7000), 7000);
  EXPECT_EQ(band_points_milli(0.6, hinge, 7000), 5250);
  EXPECT_EQ(band_points_milli(0.0, hinge, 7000), 0);
  EXPECT_EQ(band_points_milli(2.75, hinge, 7000), 3500);
  EXPECT_EQ(band_points_milli(4.0, hinge, 7000), 0);
}

TEST(Points, WhatIsNotANumberEarnsNothing) {
  EXPECT_EQ(lower_points_milli(not_a_number, 1.0, 8.0, 16000), 0);
  EXPECT_EQ(band_points_milli(not_a_number, {0.0, 1.0, 2.0, 3.0}, 16000), 0);
}

TEST(Points, StayWithinTheWeightAndNeverRiseWithTheError) {
  rc::check([] {
    const auto in_milli = [](int low, int high) {
      return static_cast<double>(*rc::gen::inRange(low, high)) / 1000.0;
    };
    const double full = in_milli(0, 5000);
    const double zero = full + in_milli(0, 5000);
    const std::int64_t weight_milli = *rc::gen::inRange(0, 100000);
    const double small = in_milli(-1000, 12000);
    const double large = small + in_milli(0, 5000);
    const std::int64_t better = lower_points_milli(small, full, zero, weight_milli);
    const std::int64_t worse = lower_points_milli(large, full, zero, weight_milli);
    RC_ASSERT(0 <= worse && worse <= better && better <= weight_milli);
  });
}

}  // namespace
}  // namespace hallux::assessment
