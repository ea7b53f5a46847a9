#include "simulator/tool/tray.h"

#include <gtest/gtest.h>

#include <array>

namespace hallux::simulator {
namespace {

TEST(Tray, BeginsWithASawAndTellsToolsByTheirPlace) {
  const std::array<Tool, 2> further{WireDriver{}, Saw{.blade = {.width_mm = 6.0}}};
  const Tray tray(Saw{.sharpness = 0.5}, further);
  EXPECT_EQ(tray.count(), 3);
  EXPECT_EQ(tray.first_saw().sharpness, 0.5);
  EXPECT_EQ(tray.saw(1), nullptr);
  ASSERT_NE(tray.saw(2), nullptr);
  EXPECT_EQ(tray.saw(2)->blade.width_mm, 6.0);
  EXPECT_FALSE(tray.has(3));
  EXPECT_FALSE(tray.has(-1));
}

TEST(Tray, KnowsWhatAToolBoresAndWhatItLeavesInTheBone) {
  EXPECT_EQ(bored_radius_mm(Saw{}), 0.0);
  EXPECT_EQ(bored_radius_mm(Drill{}), 1.0);
  EXPECT_EQ(bored_radius_mm(WireDriver{}), 0.8);
  EXPECT_FALSE(implant_of(Saw{}));
  EXPECT_FALSE(implant_of(Drill{}));
  const auto wire = implant_of(WireDriver{});
  ASSERT_TRUE(wire);
  EXPECT_FALSE(wire->is_screw);
  EXPECT_EQ(wire->length_mm, 120.0);
  const auto screw = implant_of(Screwdriver{});
  ASSERT_TRUE(screw);
  EXPECT_TRUE(screw->is_screw);
  EXPECT_EQ(screw->radius_mm, 0.5 * Screw{}.thread_diameter_mm) << "the thread holds";
  EXPECT_EQ(bored_radius_mm(Screwdriver{}), 0.5 * Screw{}.shaft_diameter_mm);
}

}  // namespace
}  // namespace hallux::simulator
