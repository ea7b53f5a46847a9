#include "simulator/tool/saw.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

TEST(Saw, ADullBladeCutsLikeANewOneThatRunsSlower) {
  EXPECT_EQ(sharp_cycles_per_minute({.cycles_per_minute = 14000.0, .sharpness = 0.5}), 7000.0);
}

TEST(Saw, ANewBladeCutsAtTheRateOfItsDrive) {
  EXPECT_EQ(sharp_cycles_per_minute({.cycles_per_minute = 9000.0}), 9000.0);
}

TEST(Blade, IsAnotherWhereOneMeasureDiffers) {
  const Blade blade{.width_mm = 9.0};
  EXPECT_EQ(blade, Blade{.width_mm = 9.0});
  EXPECT_NE(blade, (Blade{.width_mm = 9.0, .thickness_mm = 0.3}));
}

}  // namespace
}  // namespace hallux::simulator
