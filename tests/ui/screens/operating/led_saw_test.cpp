#include "ui/screens/operating/hand/led_saw.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

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

constexpr auto saw_bit = static_cast<std::uint32_t>(simulator::Switch::SawRuns),
               irrigation_bit = static_cast<std::uint32_t>(simulator::Switch::Irrigates);

/// A saw whose place is the hand's on the device.
struct HeldSaw {
  explicit HeldSaw(simulator::SteeredDevice::Led led) {
    device.leads = led;
    saw.take(device);
  }
  void move(double now_s) {
    simulator::PointerMotion motion;
    motion.across_mm = {7.0, 3.0};
    motion.rolled_rad = 0.1;
    saw.lead(std::array{motion}, upright, now_s);
  }

  NotedDevice device;
  LedSaw saw{{upright, start_mm}, {0.0, 0.0, 0.0}};
};

TEST(LedSaw, OfAnArmWithThreeJointsIsTurnedByTheWindowWhereItsHandHasIt) {
  HeldSaw held(simulator::SteeredDevice::Led::Rotation);
  const Vec3 there_mm{200.0, 10.0, -3.0};
  held.saw.see({upright, there_mm}, 0);
  held.move(1.0);
  EXPECT_EQ(held.saw.world_from_target().translation_mm, there_mm) << "a pointer leads it nowhere";
  EXPECT_LT(std::abs(held.device.aimed.world_from_target.rotation.w), 0.9999);
  EXPECT_FALSE(held.saw.is_led_by_window());
}

TEST(LedSaw, OfADeviceThatTurnsItselfIsWhereTheLoopSays) {
  HeldSaw held(simulator::SteeredDevice::Led::Nothing);
  const RigidTransform seen{Quat(0.0, 1.0, 0.0, 0.0), {1.0, 2.0, 3.0}};
  held.saw.see(seen, 0);
  held.move(1.0);
  EXPECT_TRUE(held.saw.world_from_target() == seen);
}

TEST(LedSaw, WhatTheGripHasSwitchedOnStaysWhenTheWindowOrdersAnother) {
  HeldSaw held(simulator::SteeredDevice::Led::Rotation);
  held.saw.see({upright, start_mm}, saw_bit);
  EXPECT_TRUE(held.saw.is_on()) << "as the loop says";
  held.saw.set_irrigated(true);
  held.move(1.0);
  EXPECT_EQ(held.device.aimed.switches, saw_bit | irrigation_bit);
  EXPECT_EQ(held.device.aimed.orders, 1U);
  held.move(1.1);
  EXPECT_EQ(held.device.aimed.orders, 1U) << "said again it is no other order";
  held.saw.release();
  EXPECT_EQ(held.device.aimed.switches, 0U);
  EXPECT_EQ(held.device.aimed.orders, 2U);
}

TEST(LedSaw, IsTakenOverByThePointerWhereItIs) {
  HeldSaw held(simulator::SteeredDevice::Led::Rotation);
  const Vec3 there_mm{12.0, 10.0, -3.0};
  held.saw.see({upright, there_mm}, saw_bit);
  held.saw.take_over();
  EXPECT_TRUE(held.saw.is_led_by_window());
  EXPECT_FALSE(held.saw.is_on());
  held.move(1.0);
  EXPECT_EQ(held.device.place_mm, there_mm + Vec3(7.0, 3.0, 0.0)) << "no jump";
}

}  // namespace
}  // namespace hallux::ui
