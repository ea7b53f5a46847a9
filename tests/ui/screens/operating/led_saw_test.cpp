#include "ui/screens/operating/hand/led_saw.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/ui/screens/operating/led_operation.h"

namespace hallux::ui {
namespace {

const Quat upright(1.0, 0.0, 0.0, 0.0);

TEST(LedSaw, IsNotLedOutOfReachOfTheSite) {
  NotedDevice device;
  LedSaw saw({upright, start_mm}, {0.0, 0.0, 0.0});
  saw.take(device);
  simulator::PointerMotion far;
  far.across_mm = {0.0, 500.0};
  saw.lead(std::array{far}, upright, 1.0);
  EXPECT_NEAR(device.place_mm.y, LedSaw::reach_mm, 1.0e-9);
}

TEST(LedSaw, TellsTheDeviceInEachFrameAlsoWithoutMotion) {
  NotedDevice device;
  LedSaw saw({upright, start_mm}, {0.0, 0.0, 0.0});
  saw.take(device);
  for (const double now_s : {1.0, 1.1, 1.2}) saw.lead({}, upright, now_s);
  EXPECT_EQ(device.aims, 3);
  EXPECT_EQ(device.place_mm, start_mm);
  EXPECT_FALSE(saw.is_silent(2.6));
  EXPECT_TRUE(saw.is_silent(2.8)) << "a device that hears nothing for 1.5 s stops the saw";
}

TEST(LedSaw, ThatIsLetGoStandsWhereItIsWithEverySwitchOff) {
  NotedDevice device;
  LedSaw saw({upright, start_mm}, {0.0, 0.0, 0.0});
  saw.take(device);
  saw.set_on(true);
  saw.set_irrigated(true);
  saw.lead({}, upright, 1.0);
  EXPECT_NE(device.switches, 0U);
  saw.release();
  EXPECT_EQ(device.switches, 0U);
  EXPECT_EQ(device.place_mm, start_mm);
  EXPECT_FALSE(saw.is_on());
  EXPECT_TRUE(saw.is_irrigated()) << "it flows again once somebody holds the saw";
}

}  // namespace
}  // namespace hallux::ui
