#include "simulator/tool/drill.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

TEST(DrillBit, OfEachDiameterOfTheTrayIsMade) {
  for (const double diameter_mm : drill_diameters_mm)
    EXPECT_TRUE(is_made(DrillBit{.diameter_mm = diameter_mm, .point_mm = 0.3 * diameter_mm}));
}

TEST(DrillBit, BesideWhatIsMadeIsNone) {
  EXPECT_FALSE(is_made(DrillBit{.diameter_mm = 1.0}));
  EXPECT_FALSE(is_made(DrillBit{.diameter_mm = 3.3}));
  EXPECT_FALSE(is_made(DrillBit{.length_mm = 29.0}));
  EXPECT_FALSE(is_made(DrillBit{.point_mm = 2.0}));
}

}  // namespace
}  // namespace hallux::simulator
