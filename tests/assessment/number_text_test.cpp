#include "assessment/number_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hallux::assessment {
namespace {

TEST(NumberText, HasNoMinusZeroAndNoNeedlessZeros) {
  EXPECT_EQ(number_text(-0.001, 2), "0.00");
  EXPECT_EQ(number_text(-0.5, 1), "-0.5");
  EXPECT_EQ(short_number_text(1.0), "1");
  EXPECT_EQ(short_number_text(0.25), "0.25");
  EXPECT_FALSE(std::signbit(rounded_to_micro(-1.0e-9)));
}

TEST(NumberText, NamesWhatIsNoNumber) {
  EXPECT_EQ(number_text(std::nan(""), 2), "not a number");
  EXPECT_EQ(number_text(HUGE_VAL, 2), "infinite");
}

TEST(NumberText, PointsShowWhatIsLostHoweverLittle) {
  EXPECT_EQ(points_text(16000), "16");
  EXPECT_EQ(points_text(7314), "7.3");
  EXPECT_EQ(points_text(40), "0.04");
  EXPECT_EQ(points_text(1), "0.001");
  EXPECT_EQ(points_text(0), "0");
}

TEST(NumberText, MomentsAreMinutesAndSeconds) {
  EXPECT_EQ(moment_text(0), "0:00.000");
  EXPECT_EQ(moment_text(65432000), "1:05.432");
}

}  // namespace
}  // namespace hallux::assessment
