#include "simulator/contact/bore/bore_tool.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

TEST(BoreTool, OfAWireAtTheRatedSpeedIsFedLikeTheSawOfTheLaw) {
  const BoreTool tool = bore_tool(WireDriver{.wire = {.diameter_mm = 1.1}});
  EXPECT_EQ(tool.radius_mm, 0.55);
  EXPECT_EQ(tool.law_cycles_per_minute, 12000.0);
  EXPECT_FALSE(tool.is_screw());
  EXPECT_TRUE(tool.bores);
}

TEST(BoreTool, OfADullDrillAtHalfTheSpeedIsFedAQuarter) {
  const BoreTool tool = bore_tool(Drill{.revolutions_per_minute = 500.0, .sharpness = 0.5});
  EXPECT_EQ(tool.law_cycles_per_minute, 3000.0);
}

TEST(BoreTool, OfAScrewBoresItsShaftAndGoesByItsPitch) {
  const BoreTool tool = bore_tool(Screwdriver{});
  EXPECT_EQ(tool.radius_mm, 0.95);
  EXPECT_EQ(tool.pitch_mm, 1.0);
  EXPECT_EQ(tool.turns_per_s, 2.0);
  EXPECT_EQ(tool.shaft_mm, 20.0);
  EXPECT_EQ(tool.shoulder_radius_mm, 2.5);
  EXPECT_TRUE(tool.is_screw());
  EXPECT_FALSE(tool.bores);
}

}  // namespace
}  // namespace hallux::simulator
