#include <gtest/gtest.h>

#include "simulator/device/force_output.h"
#include "simulator/device/modelled/modelled_arm.h"
#include "tests/support/allocation_counter.h"

namespace hallux::simulator {
namespace {

TEST(DeviceForce, TakesNoMemoryInAHundredThousandTicks) {
  HandMotion motion;
  motion.keys = {{0, RigidTransform{}, 1}, {1000, {{1.0, 0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}}, 1}};
  const ModelledArmSetup setup;
  ModelledArm device(motion, setup);
  const ForceOutputSettings settings = force_output_settings(setup.limits, 2.0, 1);
  ForceOutputState state;
  RawDeviceState raw;
  DeviceForce force;
  std::uint32_t limits = 0;
  const std::uint64_t before = tests::allocations_of_this_thread();
  for (std::int64_t tick = 0; tick < 100000; ++tick) {
    device.exchange(force.force_in_world_newton, tick, raw);
    const Vec3 place_mm = raw.world_from_handle.translation_mm;
    const Vec3 wall_newton(-2.0 * std::max(0.0, place_mm.x), 0.0, 0.0);
    force = output_force(state, settings,
                         {wall_newton, place_mm, {0.0, 0.1, 0.0}, 0.001, tick % 10000 != 0});
    limits |= force.limits;
  }
  EXPECT_EQ(tests::allocations_of_this_thread() - before, 0U);
  EXPECT_TRUE(has(limits, ForceLimit::Stopped) && has(limits, ForceLimit::SoftStart));
  EXPECT_GT(raw.world_from_handle.translation_mm.x, 1.0) << "it was pressed against the wall";
}

}  // namespace
}  // namespace hallux::simulator
