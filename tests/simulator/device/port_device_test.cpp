// Arms and 3D mice as the loop has them, over a port in virtual time.
#include "simulator/device/port_device.h"

#include <gtest/gtest.h>

#include "simulator/base/units.h"
#include "tests/simulator/device/port/played_driver.h"
#include "tests/simulator/device/stepped_port.h"

namespace hallux::simulator {
namespace {

constexpr auto saw = static_cast<std::uint32_t>(Switch::SawRuns);
const Vec3 no_force{0.0, 0.0, 0.0};
const RigidTransform start{rotation_about({0.0, 0.0, 1.0}, 0.5), {100.0, 20.0, -5.0}};

class HeldArm : public testing::Test {
 protected:
  void hold(const Vec3& place_mm, const Quat& rotation = {1.0, 0.0, 0.0, 0.0}) {
    driver_.otherwise.exchange.state.device_from_handle = {rotation, place_mm};
  }

  RawDeviceState exchanged(ArmDevice& arm, const Vec3& force_newton = no_force, int times = 1) {
    RawDeviceState state;
    for (int i = 0; i < times; ++i) is_there_ = arm.exchange(force_newton, tick_++, state);
    return state;
  }

  static void expect_at(const RawDeviceState& state, const Vec3& place_mm) {
    EXPECT_LT(length_of(state.world_from_handle.translation_mm - place_mm), 1e-9);
  }

  PlayedDriver driver_;
  SteppedPort port_{driver_};
  PortDeviceSetup setup_{.world_from_start = start};
  std::int64_t tick_ = 0;
  bool is_there_ = false;
};

TEST_F(HeldArm, BeginsWhereTheSawIsAndGoesTheHandsWay) {
  hold({30.0, 10.0, 0.0});
  ArmDevice arm(port_, setup_);
  expect_at(exchanged(arm), start.translation_mm);
  hold({32.0, 10.0, -1.0});
  const RawDeviceState state = exchanged(arm);
  expect_at(state, start.translation_mm + Vec3(2.0, 0.0, -1.0));
  EXPECT_GT(state.packet, 0U);
}

TEST_F(HeldArm, LiesInTheWorldAsItsFrameSaysAndIsPushedThere) {
  // The device's x is the world's y; half a millimetre for one.
  setup_.frame = {rotation_about({0.0, 0.0, 1.0}, radian_from_degree(90.0)), 0.5};
  ArmDevice arm(port_, setup_);
  exchanged(arm);
  hold({4.0, 0.0, 0.0});
  expect_at(exchanged(arm), start.translation_mm + Vec3(0.0, 2.0, 0.0));
  exchanged(arm, {0.0, 3.0, 0.0}, 1000);
  EXPECT_LT(length_of(driver_.forces_newton.back() - Vec3(3.0, 0.0, 0.0)), 1e-9);
  EXPECT_EQ(arm.description().motion_scale, 0.5);
}

TEST_F(HeldArm, WhoseGripMeasuresNoRotationIsTurnedByTheWindow) {
  ArmDevice arm(port_, setup_);
  hold({}, rotation_about({1.0, 0.0, 0.0}, 1.0));
  exchanged(arm, no_force, 100);
  const Quat wanted = rotation_about({0.0, 1.0, 0.0}, 0.4);
  arm.aim({{wanted, {}}, 0, {}});
  const RawDeviceState state = exchanged(arm, no_force, 1000);
  EXPECT_NEAR(std::abs(glm::dot(state.world_from_handle.rotation, wanted)), 1.0, 1e-9);
  expect_at(state, start.translation_mm);
}

TEST_F(HeldArm, WhoseGripMeasuresItsRotationTurnsItself) {
  driver_.described.measures_rotation = true;
  ArmDevice arm(port_, setup_);
  exchanged(arm);
  const Quat turn = rotation_about({0.0, 0.0, 1.0}, 0.2);
  hold({}, turn);
  const RawDeviceState state = exchanged(arm);
  EXPECT_NEAR(std::abs(glm::dot(state.world_from_handle.rotation, turn * start.rotation)), 1.0,
              1e-12);
}

TEST_F(HeldArm, ALiftedHandMovesNothingAndIsPushedByNothing) {
  ArmDevice arm(port_, setup_);
  exchanged(arm, {0.0, 0.0, 2.0}, 1000);
  ASSERT_EQ(driver_.forces_newton.back(), Vec3(0.0, 0.0, 2.0));
  SteeredDevice::Aim lifted{start};
  lifted.is_lifted = true;
  arm.aim(lifted);
  hold({-50.0, 0.0, 0.0});
  expect_at(exchanged(arm, {0.0, 0.0, 2.0}, 10), start.translation_mm);
  EXPECT_EQ(driver_.forces_newton.back(), no_force);
  arm.aim({start});
  expect_at(exchanged(arm, {0.0, 0.0, 2.0}, 3), start.translation_mm);
  EXPECT_LT(length_of(driver_.forces_newton.back()), 0.02) << "softly";
  hold({-49.0, 0.0, 0.0});
  expect_at(exchanged(arm), start.translation_mm + Vec3(1.0, 0.0, 0.0));
}

TEST_F(HeldArm, AButtonTurnsTheSawOnAndAKeyTurnsItOff) {
  ArmDevice arm(port_, setup_);
  driver_.otherwise.exchange.state.buttons = 1;
  EXPECT_EQ(exchanged(arm).switches, saw);
  driver_.otherwise.exchange.state.buttons = 0;
  EXPECT_EQ(exchanged(arm).switches, saw);
  SteeredDevice::Aim off{start};
  arm.aim(off);
  EXPECT_EQ(exchanged(arm).switches, saw) << "nothing was switched at the window";
  off.orders = 1;
  arm.aim(off);
  EXPECT_EQ(exchanged(arm).switches, 0U);
  driver_.otherwise.exchange.state.buttons = 1;
  EXPECT_EQ(exchanged(arm).switches, saw);
}

TEST_F(HeldArm, AWindowThatHangsStopsTheSawAlsoOfTheGrip) {
  ArmDevice arm(port_, setup_);
  arm.aim({start, 0, {}});
  driver_.otherwise.exchange.state.buttons = 1;
  EXPECT_EQ(exchanged(arm).switches, saw);
  EXPECT_EQ(exchanged(arm, no_force, SteeredDevice::silence_ticks + 2).switches, 0U);
}

TEST_F(HeldArm, LostAndThereAgainItGoesOnFromWhereTheSawIsAndSoftly) {
  ArmDevice arm(port_, setup_);
  exchanged(arm);
  hold({5.0, 0.0, 0.0});
  exchanged(arm, {0.0, 0.0, 2.0}, 1000);
  driver_.otherwise.exchange = {DriverAnswer::Gone, {}, DeviceTrouble::Unplugged};
  exchanged(arm, {0.0, 0.0, 2.0}, 5);
  EXPECT_FALSE(is_there_);
  PlayedDriver other;
  other.otherwise.exchange.state.device_from_handle.translation_mm = {-20.0, 0.0, 0.0};
  SteppedPort again(other);
  arm.go_on_with(again);
  const RawDeviceState state = exchanged(arm, {0.0, 0.0, 2.0}, 3);
  EXPECT_TRUE(is_there_);
  expect_at(state, start.translation_mm + Vec3(5.0, 0.0, 0.0));
  EXPECT_LT(length_of(other.forces_newton.back()), 0.02);
}

TEST_F(HeldArm, AStationMayAllowLessForceOrNone) {
  setup_.force_share = 0.5;
  EXPECT_EQ(ArmDevice(port_, setup_).description().limits->force_newton, 4.0);
  setup_.force_share = 0.0;
  EXPECT_FALSE(ArmDevice(port_, setup_).description().limits);
}

TEST(LedRate, IsLedByItsCapAndHeldByBone) {
  PlayedDriver driver;
  driver.described = {"SpaceMouse", "rate"};
  driver.otherwise.exchange.state.deflection.pushed = {1.0, 0.0, 0.0};
  SteppedPort port(driver);
  RateDevice mouse(port, {.world_from_start = start});
  RawDeviceState state;
  for (std::int64_t tick = 0; tick < 1000; ++tick)
    ASSERT_TRUE(mouse.exchange(no_force, tick, state));
  const double way_mm = state.world_from_handle.translation_mm.x - start.translation_mm.x;
  EXPECT_GT(way_mm, 100.0);
  EXPECT_LT(way_mm, 150.0);
  // Looked at from above, the same push goes away from the person.
  SteeredDevice::Aim seen{start};
  seen.world_from_view = rotation_about({0.0, 0.0, 1.0}, radian_from_degree(90.0));
  mouse.aim(seen);
  const double before_mm = state.world_from_handle.translation_mm.y;
  for (std::int64_t tick = 1000; tick < 2000; ++tick)
    ASSERT_TRUE(mouse.exchange({0.0, -5.0, 0.0}, tick, state));
  EXPECT_GT(state.world_from_handle.translation_mm.y - before_mm, 100.0);
  driver.otherwise.exchange = {DriverAnswer::Gone, {}, DeviceTrouble::Unplugged};
  EXPECT_FALSE(mouse.exchange(no_force, 2000, state));
}

TEST(SwitchBoard, GripAndWindowAddUpAndAnyOfThemTurnsOff) {
  SwitchBoard board(ButtonMap{.saw = 2, .irrigation = 8});
  const auto irrigation = static_cast<std::uint32_t>(Switch::Irrigates);
  EXPECT_EQ(board.combined(1, 0, 0), 0U);
  EXPECT_EQ(board.combined(2, 0, 0), saw);
  EXPECT_EQ(board.combined(2, 0, 0), saw) << "held is not pressed again";
  EXPECT_EQ(board.combined(0, 0, 1), 0U) << "ordered off";
  EXPECT_EQ(board.combined(2, 0, 1), saw) << "an order is heard once";
  EXPECT_EQ(board.combined(10, 0, 1), saw | irrigation);
  EXPECT_EQ(board.combined(0, saw, 2), saw) << "all of it is as it was ordered";
  board.release();
  EXPECT_EQ(board.combined(0, saw, 2), 0U) << "what was ordered before is over";
  EXPECT_EQ(board.combined(0, saw, 3), saw);
}

}  // namespace
}  // namespace hallux::simulator
