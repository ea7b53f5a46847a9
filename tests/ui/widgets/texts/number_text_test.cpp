#include "ui/widgets/texts/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace hallux::ui {
namespace {

TEST(NumberText, HasItsDecimals) {
  EXPECT_EQ(fixed_text(4.2, 2), "4.20");
  EXPECT_EQ(fixed_text(-0.25, 1), "-0.2");
  EXPECT_EQ(fixed_text(12000.4, 0), "12000");
}

TEST(NumberText, OfThreeDigitsHasNoNeedlessZeros) {
  EXPECT_EQ(short_text(0.5), "0.5");
  EXPECT_EQ(short_text(12.0), "12");
  EXPECT_EQ(short_text(2.345), "2.35");
}

TEST(NumberText, OfNoNumberIsADash) {
  EXPECT_EQ(fixed_text(std::numeric_limits<double>::quiet_NaN(), 1), "–");
  EXPECT_EQ(short_text(std::numeric_limits<double>::infinity()), "–");
}

}  // namespace
}  // namespace hallux::ui
