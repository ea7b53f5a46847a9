#include "simulator/device/scripted.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

constexpr auto saw = static_cast<std::uint32_t>(Switch::SawRuns);

RigidTransform at_x(double x_mm) { return {{1.0, 0.0, 0.0, 0.0}, {x_mm, 0.0, 0.0}}; }

/// At rest until tick 10, 10 mm along x until tick 30, then at rest again; the saw from tick 10.
HandMotion slide() {
  HandMotion motion;
  motion.keys = {{10, at_x(0.0), saw}, {30, at_x(10.0), 0}};
  return motion;
}

RawDeviceState state_at(ScriptedDevice& device, std::int64_t tick) {
  RawDeviceState state;
  EXPECT_TRUE(device.exchange({0.0, 0.0, 0.0}, tick, state));
  return state;
}

TEST(ScriptedDevice, IsOfTheScriptedClass) {
  EXPECT_EQ(ScriptedDevice(slide()).description().device_class, "scripted");
}

TEST(ScriptedDevice, MovesStraightBetweenKeys) {
  ScriptedDevice device(slide());
  EXPECT_EQ(state_at(device, 0).world_from_handle, at_x(0.0));
  EXPECT_EQ(state_at(device, 10).world_from_handle, at_x(0.0));
  EXPECT_NEAR(state_at(device, 15).world_from_handle.translation_mm.x, 2.5, 1e-12);
  EXPECT_NEAR(state_at(device, 29).world_from_handle.translation_mm.x, 9.5, 1e-12);
  EXPECT_EQ(state_at(device, 30).world_from_handle, at_x(10.0));
  EXPECT_EQ(state_at(device, 1000).world_from_handle, at_x(10.0));
}

TEST(ScriptedDevice, SwitchesHoldFromTheirKeyToTheNext) {
  ScriptedDevice device(slide());
  EXPECT_EQ(state_at(device, 10).switches, saw);
  EXPECT_EQ(state_at(device, 29).switches, saw);
  EXPECT_EQ(state_at(device, 30).switches, 0U);
}

TEST(ScriptedDevice, TicksThatWereMissedAreSkipped) {
  ScriptedDevice device(slide());
  EXPECT_NEAR(state_at(device, 20).world_from_handle.translation_mm.x, 5.0, 1e-12);
}

TEST(ScriptedDevice, FeelsNothing) {
  ScriptedDevice one(slide()), other(slide());
  RawDeviceState quiet, pushed;
  for (std::int64_t tick = 0; tick < 40; ++tick) {
    one.exchange({0.0, 0.0, 0.0}, tick, quiet);
    other.exchange({30.0, -30.0, 30.0}, tick, pushed);
    EXPECT_EQ(quiet.world_from_handle, pushed.world_from_handle);
  }
}

TEST(HandMotion, EndsWithItsLastKeyOrCommand) {
  HandMotion motion = slide();
  EXPECT_EQ(motion.last_tick(), 30);
  motion.commands = {{50, {CommandKind::Finish, 0, 0}}};
  EXPECT_EQ(motion.last_tick(), 50);
  EXPECT_EQ(HandMotion{}.last_tick(), 0);
}

TEST(ScriptedDeviceDeathTest, RefusesKeysThatAreMissingOrOutOfOrder) {
  EXPECT_DEATH(ScriptedDevice{HandMotion{}}, "empty");
  HandMotion motion = slide();
  std::swap(motion.keys[0], motion.keys[1]);
  EXPECT_DEATH(ScriptedDevice{motion}, "is_sorted");
}

}  // namespace
}  // namespace hallux::simulator
