// A port in virtual time: what a device is given, and when it is lost.
#include "simulator/device/port/port_cycle.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/simulator/device/port/played_driver.h"

namespace hallux::simulator {
namespace {

using std::chrono::milliseconds;
const Vec3 push_newton{1.0, 2.0, -2.0};
const Vec3 none_newton{0.0, 0.0, 0.0};

class PlayedPort : public testing::Test {
 protected:
  /// So many exchanges; the borrower says a force before each, or has said its last.
  void run(int exchanges, bool is_said = true) {
    for (int i = 0; i < exchanges && !cycle_.is_over(); ++i) {
      if (is_said) said_ = {push_newton, said_.number + 1};
      cycle_.run(said_, [&] { return driver_.now; });
    }
  }

  void answer(int times, DriverAnswer answer, std::chrono::microseconds takes = milliseconds(1)) {
    for (int i = 0; i < times; ++i) driver_.answers.push_back({{answer, {}, {}}, takes});
  }

  const Vec3& given_newton() const { return driver_.forces_newton.back(); }

  PlayedDriver driver_;
  PortCycle cycle_{driver_, driver_.now};
  SaidForce said_;
};

TEST_F(PlayedPort, ForceBeginsSoftlyAndIsThenWhatWasSaid) {
  run(2);
  EXPECT_LT(length_of(given_newton()), 0.01);
  run(250);
  EXPECT_NEAR(length_of(given_newton()), 1.5, 0.02);
  run(300);
  EXPECT_EQ(given_newton(), push_newton);
}

TEST_F(PlayedPort, WhoFallsSilentPushesNobodyAndBeginsSoftlyAgain) {
  run(600);
  run(5, false);
  EXPECT_EQ(given_newton(), push_newton) << "within the patience";
  run(2, false);
  EXPECT_EQ(given_newton(), none_newton);
  run(100, false);
  EXPECT_EQ(given_newton(), none_newton);
  EXPECT_GE(cycle_.statistics().zeros, 100U);
  run(1);
  EXPECT_LT(length_of(given_newton()), 0.01);
  run(600);
  EXPECT_EQ(given_newton(), push_newton);
}

TEST_F(PlayedPort, AForceThatIsNoNumberIsNone) {
  run(600);
  said_ = {{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, said_.number + 1};
  cycle_.run(said_, [&] { return driver_.now; });
  EXPECT_EQ(given_newton(), none_newton);
}

TEST_F(PlayedPort, ADeviceThatIsNotHomedIsGivenNothing) {
  driver_.otherwise.exchange.state.is_homed = false;
  run(700);
  EXPECT_EQ(cycle_.state().phase, PortPhase::Homing);
  EXPECT_EQ(cycle_.statistics().greatest_force_newton, 0.0);
  driver_.otherwise.exchange.state.is_homed = true;
  run(2);
  EXPECT_EQ(cycle_.state().phase, PortPhase::Running);
  EXPECT_LT(length_of(given_newton()), 0.01);
}

TEST_F(PlayedPort, ASilentDeviceIsGivenNothingWithinFivePacketsAndIsLostLater) {
  run(600);
  driver_.otherwise.exchange.answer = DriverAnswer::Nothing;
  run(5);
  EXPECT_EQ(cycle_.statistics().zeros, 0U);
  run(1);
  EXPECT_EQ(given_newton(), none_newton);
  EXPECT_FALSE(cycle_.is_over());
  run(200);
  EXPECT_TRUE(cycle_.is_over());
  EXPECT_EQ(cycle_.state().trouble, DeviceTrouble::Silent);
}

TEST_F(PlayedPort, ADeviceThatSpeaksOnlyWhenItChangesIsNeverSilent) {
  driver_.described.pulse = {};
  driver_.described.limits.reset();
  PortCycle quiet(driver_, driver_.now);
  driver_.otherwise = {{DriverAnswer::Nothing, {}, {}}, milliseconds(8)};
  for (int i = 0; i < 1000; ++i) quiet.run({}, [&] { return driver_.now; });
  EXPECT_FALSE(quiet.is_over());
}

TEST_F(PlayedPort, OneThatSaysNothingButRubbishIsLost) {
  run(10);
  answer(19, DriverAnswer::Garbled);
  run(20);
  EXPECT_FALSE(cycle_.is_over()) << "a packet came in between";
  EXPECT_EQ(cycle_.statistics().bad_packets, 19U);
  answer(20, DriverAnswer::Garbled);
  run(20);
  EXPECT_EQ(cycle_.state().trouble, DeviceTrouble::Garbled);
}

TEST_F(PlayedPort, OneThatIsGoneSaysWhy) {
  run(10);
  driver_.otherwise.exchange = {DriverAnswer::Gone, {}, DeviceTrouble::Unplugged};
  run(1);
  EXPECT_TRUE(cycle_.is_over());
  EXPECT_EQ(cycle_.state().trouble, DeviceTrouble::Unplugged);
}

TEST_F(PlayedPort, OneThatAnswersTooLateForAForceGetsNoneAndIsKept) {
  driver_.otherwise.takes = milliseconds(4);
  driver_.described.pulse.period_ticks = 4;
  PortCycle slow(driver_, driver_.now);
  for (int i = 0; i < 400; ++i) {
    said_ = {push_newton, said_.number + 1};
    slow.run(said_, [&] { return driver_.now; });
  }
  EXPECT_EQ(slow.state().trouble, DeviceTrouble::TooSlow);
  EXPECT_EQ(slow.state().phase, PortPhase::Running);
  EXPECT_EQ(given_newton(), none_newton);
}

TEST_F(PlayedPort, LatePacketsAreCounted) {
  run(10);
  answer(3, DriverAnswer::Nothing);
  run(10);
  EXPECT_EQ(cycle_.statistics().late_packets, 1U);
  EXPECT_EQ(cycle_.statistics().packets, 17U);
  EXPECT_EQ(cycle_.state().packet, 17U);
}

}  // namespace
}  // namespace hallux::simulator
