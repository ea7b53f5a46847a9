#include "simulator/device/raw_hid_arm/arm_driver.h"

#include <gtest/gtest.h>

#include "tests/support/served_bus/played_channels.h"

namespace hallux::simulator {
namespace {

const OpeningWatch go_on = [](PortPhase, double) { return true; };

class PlayedArm : public testing::Test {
 protected:
  void SetUp() override { ASSERT_FALSE(driver_.open(go_on)); }

  DriverExchange exchanged(int times, const Vec3& force_newton = {0.0, 0.0, 0.0}) {
    DriverExchange exchange;
    for (int i = 0; i < times; ++i) exchange = driver_.exchange(force_newton);
    return exchange;
  }

  void calibrate() {
    model_.is_pressed = true;
    exchanged(501);
    model_.is_pressed = false;
    ASSERT_TRUE(exchanged(1).state.is_homed);
  }

  tests::ArmModel model_;
  bool is_gone_ = false;
  ArmGeometry geometry_;
  ArmDriver driver_{[this] {
                      return OpenedHid{std::make_unique<tests::PlayedHid>(model_, is_gone_), {}};
                    },
                    geometry_};
};

TEST_F(PlayedArm, IsCalibratedInItsStandByItsButton) {
  model_.encoders = {12, 34, 56, 7, 8, 9};
  model_.is_pressed = true;
  EXPECT_FALSE(exchanged(499, {1.0, 1.0, 1.0}).state.is_homed);
  EXPECT_EQ(model_.currents_ma, (std::array<std::int16_t, 3>{}));
  model_.is_pressed = false;
  EXPECT_FALSE(exchanged(10).state.is_homed) << "it was let go before";
  calibrate();
  EXPECT_EQ(model_.encoders, (std::array<std::int16_t, 6>{0, 0, 6000, 0, 0, 0}));
  EXPECT_LT(
      length_of(exchanged(1).state.device_from_handle.translation_mm - Vec3(0.0, 205.0, 25.0)),
      1e-9);
}

TEST_F(PlayedArm, PushesAsItsJointsNeedIt) {
  calibrate();
  exchanged(1, {0.0, 1.0, 0.0});
  const MotorCurrents wanted = motor_currents(geometry_, geometry_.at_rest, {0.0, 1.0, 0.0});
  for (std::size_t i = 0; i < arm_motors; ++i)
    EXPECT_NEAR(model_.currents_ma[i], 1000.0 * wanted[i], 0.51);
  EXPECT_GT(std::abs(model_.currents_ma[2]), 100);
}

TEST_F(PlayedArm, ClosingLeavesNoForce) {
  calibrate();
  exchanged(1, {0.0, 1.0, 0.0});
  driver_.close();
  EXPECT_EQ(model_.currents_ma, (std::array<std::int16_t, 3>{}));
  EXPECT_EQ(exchanged(1).answer, DriverAnswer::Gone);
}

TEST_F(PlayedArm, SilenceRubbishAndAPulledPlugAreTold) {
  model_.is_silent = true;
  EXPECT_EQ(exchanged(1).answer, DriverAnswer::Nothing);
  model_.is_silent = false;
  model_.report_bytes = 63;
  EXPECT_EQ(exchanged(1).answer, DriverAnswer::Garbled);
  model_.report_bytes = 200;
  EXPECT_EQ(exchanged(1).answer, DriverAnswer::Garbled);
  model_.report_bytes = 64;
  EXPECT_EQ(exchanged(1).answer, DriverAnswer::Said);
  is_gone_ = true;
  EXPECT_EQ(exchanged(1).trouble, DeviceTrouble::Unplugged);
}

TEST_F(PlayedArm, AButtonHeldWhileItWorksCalibratesNothing) {
  calibrate();
  model_.encoders = {100, 200, 5000, 0, 0, 0};
  model_.is_pressed = true;
  EXPECT_EQ(exchanged(1000).state.buttons, 1U);
  EXPECT_EQ(model_.encoders[2], 5000);
}

}  // namespace
}  // namespace hallux::simulator
