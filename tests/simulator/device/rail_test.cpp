#include "simulator/device/rail.h"

#include <gtest/gtest.h>

#include "simulator/base/units.h"
#include "simulator/device/mouse.h"
#include "simulator/record/record.h"

namespace hallux::simulator {
namespace {

/// A blade whose normal is z.
const Rail rail{Vec3{0.0, 0.0, 1.0}, 2.0};

RigidTransform tilted(double tilt_rad, const Vec3& place_mm) {
  return {rotation_about(Vec3{1.0, 0.0, 0.0}, tilt_rad), place_mm};
}

TEST(Rail, IsReachedAtItsSpeedAndThenHeld) {
  RigidTransform pose = tilted(0.3, {1.0, 4.0, 8.0});
  pose = railed(pose, rail, 0.1);
  EXPECT_NEAR(pose.translation_mm.z, 6.0, 1.0e-9);
  EXPECT_NEAR(std::abs(axis_z(pose).y), std::sin(0.24), 1.0e-9);
  for (int i = 0; i < 10; ++i) pose = railed(pose, rail, 0.1);
  EXPECT_TRUE(lies_in(rail, pose));
  EXPECT_NEAR(pose.translation_mm.x, 1.0, 1.0e-9);
  EXPECT_NEAR(pose.translation_mm.y, 4.0, 1.0e-9);
}

TEST(Rail, TakesABladeEitherWayRound) {
  RigidTransform pose = tilted(pi - 0.1, {0.0, 0.0, 2.0});
  pose = railed(pose, rail, 1.0);
  EXPECT_NEAR(axis_z(pose).z, -1.0, 1.0e-9);
}

TEST(Rail, AHandOnItYieldsToBoneInItsPlaneAndNotAcrossIt) {
  MouseDevice device(tilted(0.0, {0.0, 0.0, 2.0}));
  const auto pushed_mm = [&](const Vec3& unyielding) {
    device.aim({tilted(0.0, {0.0, 0.0, 2.0}), 0, unyielding});
    RawDeviceState state;
    for (std::int64_t tick = 0; tick < 1000; ++tick)
      EXPECT_TRUE(device.exchange({5.0, 0.0, 5.0}, tick, state));
    return state.world_from_handle.translation_mm - Vec3{0.0, 0.0, 2.0};
  };
  const Vec3 free_mm = pushed_mm({0.0, 0.0, 0.0});
  EXPECT_NEAR(free_mm.z, 5.0, 0.01);
  const Vec3 railed_mm = pushed_mm(rail.normal_in_world);
  EXPECT_NEAR(railed_mm.x, 5.0, 0.01);
  EXPECT_EQ(railed_mm.z, 0.0);
}

}  // namespace
}  // namespace hallux::simulator
