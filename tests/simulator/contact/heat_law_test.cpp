#include "simulator/contact/heat_law.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace hallux::simulator {
namespace {

TEST(HeatLaw, AMinuteAt47DegreesIsADoseOf16) { EXPECT_NEAR(dose_rate(47.0), 16.0, 1e-12); }

TEST(HeatLaw, AMinuteAt43DegreesIsAMinute) { EXPECT_NEAR(dose_rate(43.0), 1.0, 1e-15); }

TEST(HeatLaw, Below43DegreesADegreeLessTakesFourTimesAsLong) {
  EXPECT_NEAR(dose_rate(41.0), dose_rate(42.0) / 4.0, 1e-15);
  EXPECT_NEAR(dose_rate(45.0), dose_rate(44.0) * 2.0, 1e-12);
  EXPECT_EQ(dose_rate(39.0), 0.0);
  EXPECT_EQ(dose_rate(body_celsius), 0.0);
}

TEST(HeatLaw, TeethOfABladeOf25MillimetresRun650MillimetresASecondAt10000Cycles) {
  // 4 x 25 sin(2.25 degrees) 10000 / 60
  EXPECT_NEAR(mean_tooth_speed_mm_s(25.0, 10000.0), 654.3, 0.1);
}

TEST(HeatLaw, AnExcessFallsToAShareOfOneOverEInOneTimeConstant) {
  const Cooling cooling = cooling_over(cooling_s, false);
  EXPECT_NEAR(warmed_celsius(47.0, 0.0, cooling), 37.0 + 10.0 / std::exp(1.0), 1e-12);
}

TEST(HeatLaw, RinsedBoneAtRestIsBetweenWaterAndBody) {
  // (37 / 5 + 2.76 x 20) / (1 / 5 + 2.76)
  EXPECT_NEAR(warmed_celsius(37.0, 0.0, cooling_over(100.0, true)), 21.1486, 1e-3);
}

TEST(HeatLaw, NeverGoesAboveItsCeiling) {
  EXPECT_EQ(warmed_celsius(37.0, 1.0e6, cooling_over(1.0, false)), ceiling_celsius);
}

RC_GTEST_PROP(HeatLaw, ASpanInPartsIsTheSpanAsAWhole, ()) {
  const double from_celsius = *rc::gen::inRange(2000, 9000) * 0.01;
  const double heating = *rc::gen::inRange(0, 1000) * 0.01;
  const bool is_rinsed = *rc::gen::arbitrary<bool>();
  const double first_s = *rc::gen::inRange(1, 5000) * 0.001;
  const double second_s = *rc::gen::inRange(1, 5000) * 0.001;
  const double in_parts =
      warmed_celsius(warmed_celsius(from_celsius, heating, cooling_over(first_s, is_rinsed)),
                     heating, cooling_over(second_s, is_rinsed));
  const double whole =
      warmed_celsius(from_celsius, heating, cooling_over(first_s + second_s, is_rinsed));
  // Temperatures below 120 degrees, a dozen roundings each.
  RC_ASSERT(std::abs(in_parts - whole) <= 1e-12 * 120.0);
}

RC_GTEST_PROP(HeatLaw, IsStableForAnySpan, ()) {
  const double from_celsius = *rc::gen::inRange(20, 121);
  const Cooling cooling = cooling_over(*rc::gen::inRange(1, 100000) * 0.001, true);
  const double to_celsius = warmed_celsius(from_celsius, 0.0, cooling);
  RC_ASSERT(to_celsius >= std::min(from_celsius, water_celsius));
  RC_ASSERT(to_celsius <= std::max(from_celsius, body_celsius));
}

}  // namespace
}  // namespace hallux::simulator
