// Each driver behind its port and the loop's end of a device, in virtual time: a modelled device is
// pressed against a simulated wall.
//
//     hand --push--> grip of a model --packets--> driver --> port --> device --> loop: wall
//                         ^-- motors <--            <--       <--       <--   scaled force
#include <gtest/gtest.h>

#include <memory>

#include "simulator/base/units.h"
#include "simulator/device/falcon/falcon_driver.h"
#include "simulator/device/port_device.h"
#include "simulator/device/raw_hid_arm/arm_driver.h"
#include "simulator/loop/device_link.h"
#include "tests/simulator/device/stepped_port.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/support/served_bus/held_models.h"
#include "tests/support/served_bus/played_channels.h"

namespace hallux::simulator {
namespace {

constexpr double counts_per_newton_metre = 4800.0;
constexpr double push_newton = 1.5, before_wall_mm = 2.0;
const OpeningWatch go_on = [](PortPhase, double) { return true; };

/// A device whose grip somebody pushes to the right, and the loop's end of it.
class Pressed {
 public:
  Pressed(std::unique_ptr<DeviceDriver> driver, tests::HeldGrip& grip, double motion_scale)
      : grip_(grip),
        driver_(std::move(driver)),
        port_(*driver_),
        arm_(port_, {.world_from_start = {{1.0, 0.0, 0.0, 0.0}, {-before_wall_mm, 0.0, 0.0}},
                     .frame = {{1.0, 0.0, 0.0, 0.0}, motion_scale}}),
        link_(arm_, tests::setup_for(bone_, motion_, 100).simulation) {}

  /// The wall begins at x = 0 in the world and is as stiff as the coupling.
  void press(std::int64_t ticks) {
    for (std::int64_t i = 0; i < ticks; ++i, ++tick_) {
      const DeviceState state = link_.read(tick_, 1);
      if (state.faults != 0) ++faulted_ticks_;
      const double deep_mm = mm_from_um(state.world_from_handle.translation_um[0]);
      StepOutput output;
      output.sample.status = bit(ToolStatus::Running) | bit(ToolStatus::InContact);
      output.sample.force_mn[0] =
          millinewton_from_newton(-wall_newton_per_mm() * std::max(0.0, deep_mm));
      link_.set_force(output, 1);
      deep_mm_ = deep_mm;
    }
  }

  /// From now on the hand wants to be where the wall begins, so far away, and pushes besides.
  void push(double way_mm) {
    grip_.hand.wanted_mm = {way_mm, 0.0, 0.0};
    grip_.hand.push_newton = {push_newton, 0.0, 0.0};
  }

  double wall_newton_per_mm() const { return ContactSettings{}.coupling_newton_per_mm; }
  double deep_mm() const { return deep_mm_; }
  double scale() const { return link_.scale(); }
  std::int64_t faulted_ticks() const { return faulted_ticks_; }
  const tests::HeldGrip& grip() const { return grip_; }

 private:
  Bone bone_ = tests::loop_block();
  HandMotion motion_ = tests::sawing_motion(bone_, 100);
  tests::HeldGrip& grip_;
  std::unique_ptr<DeviceDriver> driver_;
  SteppedPort port_;
  ArmDevice arm_;
  DeviceLink link_;
  std::int64_t tick_ = 0, faulted_ticks_ = 0;
  double deep_mm_ = 0.0;
};

tests::HeldGrip grip_with(std::int32_t transport_ticks) {
  tests::HeldGrip grip;
  grip.traits.transport_ticks = transport_ticks;
  grip.traits.encoder_step_mm = 1e-6;
  return grip;
}

/// At rest where the wall's stiffness in the hand, scale x motion scale x K, bears the push.
void expect_borne(Pressed& pressed, double motion_scale, double encoder_mm) {
  // In air until every soft start is over: a force that grows on who is deep already gives energy.
  pressed.press(1200);
  pressed.push(before_wall_mm / motion_scale);
  pressed.press(6000);
  const double in_hand_newton_per_mm =
      pressed.scale() * motion_scale * pressed.wall_newton_per_mm();
  const double deep_in_hand_mm = pressed.deep_mm() / motion_scale;
  const double expected_mm =
      push_newton / (in_hand_newton_per_mm + pressed.grip().hand.stiffness_newton_per_mm);
  EXPECT_NEAR(deep_in_hand_mm, expected_mm, 0.02 * expected_mm + encoder_mm);
  EXPECT_LE(in_hand_newton_per_mm, 0.5 * 3.0 + 1e-9) << "half of the stiffest that it renders";
  // One encoder step at the force that is held.
  EXPECT_GT(pressed.grip().least_of_motors_millijoule, -push_newton * encoder_mm - 0.02);
  EXPECT_EQ(pressed.faulted_ticks(), 0);
}

class PressedDrivers : public testing::TestWithParam<std::tuple<double, int>> {};

TEST_P(PressedDrivers, TheFalconBearsAPushAsStifflyAsItsScalesSay) {
  const auto& [motion_scale, transport_ticks] = GetParam();
  tests::HeldGrip grip = grip_with(transport_ticks);
  tests::FalconModel falcon;
  hold(falcon, grip, counts_per_newton_metre);
  bool is_gone = false;
  auto driver = std::make_unique<FalconDriver>(
      [&] {
        return OpenedUsb{std::make_unique<tests::PlayedUsb>(falcon, is_gone), {}};
      },
      FalconSettings{{}, counts_per_newton_metre});
  ASSERT_FALSE(driver->open(go_on));
  Pressed pressed(std::move(driver), grip, motion_scale);
  constexpr double count_mm = 0.05;
  expect_borne(pressed, motion_scale, count_mm);
}

TEST_P(PressedDrivers, TheOpenArmBearsAPushAsStifflyAsItsScalesSay) {
  const auto& [motion_scale, transport_ticks] = GetParam();
  tests::HeldGrip grip = grip_with(transport_ticks);
  ArmGeometry geometry;
  geometry.at_rest = {0, 3000, 6000, 0, 0, 0};
  tests::ArmModel board;
  bool is_gone = false;
  auto driver = std::make_unique<ArmDriver>(
      [&] {
        return OpenedHid{std::make_unique<tests::PlayedHid>(board, is_gone), {}};
      },
      geometry);
  ASSERT_FALSE(driver->open(go_on));
  board.is_pressed = true;
  for (int i = 0; i < 502; ++i) static_cast<void>(driver->exchange({0.0, 0.0, 0.0}));
  board.is_pressed = false;
  hold(board, grip, geometry);
  Pressed pressed(std::move(driver), grip, motion_scale);
  constexpr double count_mm = 0.08;
  expect_borne(pressed, motion_scale, count_mm);
}

INSTANTIATE_TEST_SUITE_P(ScalesAndDelays, PressedDrivers,
                         testing::Combine(testing::Values(0.5, 1.0, 2.0),
                                          testing::Values(0, 1, 2, 3)));

}  // namespace
}  // namespace hallux::simulator
