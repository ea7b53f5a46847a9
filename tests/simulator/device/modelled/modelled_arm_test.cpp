#include "simulator/device/modelled/modelled_arm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::simulator {
namespace {

RigidTransform at_x(double x_mm) { return {{1.0, 0.0, 0.0, 0.0}, {x_mm, 0.0, 0.0}}; }

HandMotion slide_to(double x_mm) {
  HandMotion motion;
  motion.keys = {{0, at_x(0.0), 1}, {200, at_x(x_mm), 1}};
  return motion;
}

RawDeviceState state_after(ModelledArm& device, std::int64_t ticks, const Vec3& force_newton) {
  RawDeviceState state;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    EXPECT_TRUE(device.exchange(force_newton, tick, state));
  }
  return state;
}

TEST(ModelledArm, FollowsItsHandAndIsHeldBackByAForce) {
  const ModelledArmSetup calm{.hand = {.tremor_mm = 0.0}};
  ModelledArm free(slide_to(10.0), calm), held(slide_to(10.0), calm);
  EXPECT_NEAR(state_after(free, 1500, {0.0, 0.0, 0.0}).world_from_handle.translation_mm.x, 10.0,
              0.02);
  // 1.5 N against a hand of 0.3 N/mm: 5 mm short.
  const RawDeviceState state = state_after(held, 1500, {-1.5, 0.0, 0.0});
  EXPECT_NEAR(state.world_from_handle.translation_mm.x, 5.0, 0.02);
  EXPECT_EQ(state.switches, 1U);
}

TEST(ModelledArm, SaysItsLimitsAndItsTransport) {
  ModelledArmSetup setup;
  setup.arm.transport_ticks = 2;
  const DeviceDescription said = ModelledArm(slide_to(1.0), setup).description();
  EXPECT_EQ(said.device_class, "arm");
  ASSERT_TRUE(said.limits.has_value());
  EXPECT_EQ(said.limits->transport_ticks, 2);
  EXPECT_EQ(said.limits->force_newton, 8.0);
}

TEST(ModelledArm, TheSameSeedIsTheSameMotionAndAnotherIsNot) {
  const auto end_of = [](std::uint64_t seed) {
    ModelledArm device(slide_to(10.0), {.seed = seed});
    return state_after(device, 700, {0.0, 0.0, 0.0}).world_from_handle;
  };
  EXPECT_EQ(end_of(4), end_of(4));
  EXPECT_NE(end_of(4), end_of(5));
}

TEST(ModelledArm, NeverStaysTheSameForLongerThanItSays) {
  ModelledArm device(slide_to(10.0), {});
  RawDeviceState before, state;
  std::int64_t same_ticks = 0, longest = 0;
  for (std::int64_t tick = 0; tick < 100000; ++tick) {
    device.exchange({0.0, 0.0, 0.0}, tick, state);
    same_ticks = state.world_from_handle == before.world_from_handle ? same_ticks + 1 : 0;
    longest = std::max(longest, same_ticks);
    before = state;
  }
  EXPECT_LE(longest, ModelledArm::flicker_ticks);
}

TEST(Tremor, HasItsSizeInEachDirectionAndAFrequencyOfAboutTen) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Tremor tremor(seed, 0.05);
    Vec3 squares(0.0, 0.0, 0.0);
    int crossings = 0;
    constexpr int ticks = 60000;
    for (int tick = 0; tick < ticks; ++tick) {
      const Vec3 away_mm = tremor.at(second_from_tick(tick));
      squares += away_mm * away_mm;
      if (away_mm.x * tremor.at(second_from_tick(tick + 1)).x < 0.0) ++crossings;
    }
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(std::sqrt(squares[axis] / ticks), 0.05, 0.01) << "seed " << seed;
    }
    EXPECT_GT(crossings, 2 * 60 * 7) << "seed " << seed;
    EXPECT_LT(crossings, 2 * 60 * 13) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hallux::simulator
