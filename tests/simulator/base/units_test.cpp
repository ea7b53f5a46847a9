#include "simulator/base/units.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace hallux {
namespace {

TEST(Units, RoundsHalvesAwayFromZero) {
  EXPECT_EQ(round_to_int32(0.5), 1);
  EXPECT_EQ(round_to_int32(-0.5), -1);
  EXPECT_EQ(round_to_int32(0.4), 0);
  EXPECT_EQ(round_to_int32(-1.4), -1);
}

TEST(Units, RoundingSaturatesAndMakesNothingOfNan) {
  EXPECT_EQ(round_to_int32(1.0e30), 2147483647);
  EXPECT_EQ(round_to_int32(-1.0e30), -2147483647);
  EXPECT_EQ(round_to_int32(std::numeric_limits<double>::infinity()), 2147483647);
  EXPECT_EQ(round_to_int32(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(Units, DegreesGoThereAndBack) {
  EXPECT_DOUBLE_EQ(radian_from_degree(180.0), pi);
  EXPECT_DOUBLE_EQ(degree_from_radian(radian_from_degree(15.0)), 15.0);
}

TEST(Units, ATickIsAMillisecond) {
  EXPECT_EQ(time_us_from_tick(1500), 1'500'000);
  EXPECT_DOUBLE_EQ(second_from_tick(1500), 1.5);
}

RC_GTEST_PROP(Units, QuantaComeBackUnchanged, (std::int32_t quanta)) {
  RC_PRE(quanta > -2147483647);
  RC_ASSERT(um_from_mm(mm_from_um(quanta)) == quanta);
  RC_ASSERT(micro_from_unit(unit_from_micro(quanta)) == quanta);
  RC_ASSERT(millinewton_from_newton(newton_from_millinewton(quanta)) == quanta);
}

}  // namespace
}  // namespace hallux
