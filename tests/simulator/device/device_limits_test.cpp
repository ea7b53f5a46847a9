#include "simulator/device/device_limits.h"

#include <gtest/gtest.h>

#include "simulator/device/mouse.h"
#include "simulator/device/scripted.h"

namespace hallux::simulator {
namespace {

TEST(ForceScale, APushOfTwentyNewtonTakesSixTenthsOfTheDevice) {
  EXPECT_DOUBLE_EQ(usual_force_scale(8.0) * 20.0, 0.6 * 8.0);
  EXPECT_DOUBLE_EQ(usual_force_scale(3.3) * 20.0, 0.6 * 3.3);
}

TEST(ForceScale, NeverMakesAForceGreater) { EXPECT_EQ(usual_force_scale(100.0), 1.0); }

TEST(ForceScale, ADeviceMaySayItsOwn) {
  const DeviceLimits limits{
      .force_newton = 8.0, .stiffness_newton_per_mm = 3.0, .force_scale = 0.03};
  EXPECT_EQ(force_scale_on(limits, 2.0), 0.03);
}

TEST(ForceScale, TakesAtMostHalfOfTheStiffnessThatTheDeviceRenders) {
  const DeviceLimits limits{
      .force_newton = 40.0, .stiffness_newton_per_mm = 0.8, .force_scale = std::nullopt};
  EXPECT_DOUBLE_EQ(force_scale_on(limits, 2.0) * 2.0, 0.4);
  EXPECT_DOUBLE_EQ(force_scale_on(limits, 0.1), 1.0) << "a contact soft enough keeps its scale";
}

TEST(DeviceDescription, WhatPushesNobodyBackHasNoLimits) {
  EXPECT_FALSE(MouseDevice(RigidTransform{}).description().limits.has_value());
  HandMotion motion;
  motion.keys = {{0, RigidTransform{}, 0}};
  EXPECT_FALSE(ScriptedDevice(motion).description().limits.has_value());
}

}  // namespace
}  // namespace hallux::simulator
