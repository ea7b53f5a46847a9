#include "simulator/tool/wire.h"

#include <gtest/gtest.h>

#include <limits>

namespace hallux::simulator {
namespace {

TEST(Wire, OfEachDiameterOfTheTrayIsMade) {
  for (const double diameter_mm : wire_diameters_mm)
    EXPECT_TRUE(is_made(Wire{.diameter_mm = diameter_mm, .point_mm = 2.0 * diameter_mm}));
}

TEST(Wire, BesideWhatIsMadeIsNone) {
  EXPECT_FALSE(is_made(Wire{.diameter_mm = 0.8}));
  EXPECT_FALSE(is_made(Wire{.diameter_mm = 2.1}));
  EXPECT_FALSE(is_made(Wire{.length_mm = 20.0}));
  EXPECT_FALSE(is_made(Wire{.point_mm = 0.1}));
  EXPECT_FALSE(is_made(Wire{.diameter_mm = std::numeric_limits<double>::quiet_NaN()}));
}

TEST(Wire, IsAnotherWhereOneMeasureDiffers) {
  EXPECT_EQ(Wire{.diameter_mm = 1.1}, Wire{.diameter_mm = 1.1});
  EXPECT_NE(Wire{.diameter_mm = 1.1}, (Wire{.diameter_mm = 1.1, .length_mm = 70.0}));
}

}  // namespace
}  // namespace hallux::simulator
