#include "simulator/loop/watchdog.h"

#include <gtest/gtest.h>

#include <limits>

namespace hallux::simulator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr DevicePulse living{.flicker_ticks = 2, .numbers_packets = true};

RawDeviceState at_x(double x_mm, std::uint64_t packet) {
  return {{{1.0, 0.0, 0.0, 0.0}, {x_mm, 0.0, 0.0}}, 1, packet};
}

/// A watchdog that has seen ten good states, the last at x = 0.9 mm in packet 10.
DeviceWatchdog watching(const DevicePulse& pulse) {
  DeviceWatchdog watchdog(pulse);
  for (std::uint64_t i = 0; i < 10; ++i) {
    const DeviceState state = watchdog.judge(true, at_x(0.1 * static_cast<double>(i), i + 1), 1);
    EXPECT_EQ(state.faults, 0U);
    EXPECT_EQ(state.switches, 1U);
  }
  return watchdog;
}

TEST(Watchdog, BelievesWhatMovesAsAHandDoesAndRoundsIt) {
  DeviceWatchdog watchdog = watching(living);
  const DeviceState state = watchdog.judge(true, at_x(1.00049, 11), 1);
  EXPECT_EQ(state.faults, 0U);
  EXPECT_EQ(state.world_from_handle.translation_um[0], 1000);
  EXPECT_EQ(watchdog.last_good().translation_mm.x, 1.00049);
}

TEST(Watchdog, APacketMayBeTwoTicksLateAndNotThree) {
  DeviceWatchdog watchdog = watching(living);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 10), 1).faults, 0U);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 10), 1).faults, 0U);
  const DeviceState late = watchdog.judge(true, at_x(0.9, 10), 1);
  EXPECT_EQ(late.faults, bit(DeviceFault::Late));
  EXPECT_EQ(late.switches, 0U) << "a saw that nobody is heard to hold stops";
  EXPECT_EQ(late.world_from_handle.translation_um[0], 900);
  EXPECT_EQ(watchdog.judge(true, at_x(1.0, 11), 1).faults, 0U) << "and it goes on with the next";
}

TEST(Watchdog, OneThatSpeaksEveryEighthTickMayBeTwoOfItsPeriodsLate) {
  DeviceWatchdog watchdog({.numbers_packets = true, .period_ticks = 8});
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 1), 1).faults, 0U);
  for (int tick = 0; tick < 16; ++tick) EXPECT_EQ(watchdog.judge(true, at_x(0.9, 1), 1).faults, 0U);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 1), 1).faults, bit(DeviceFault::Late));
}

TEST(Watchdog, TicksThatALineCoversCountAsTicks) {
  DeviceWatchdog watchdog = watching(living);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 10), 2).faults, 0U);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 10), 1).faults, bit(DeviceFault::Late));
}

TEST(Watchdog, APoseThatNeverFlickersIsFrozen) {
  DeviceWatchdog watchdog = watching(living);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 11), 1).faults, 0U);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 12), 1).faults, 0U);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9, 13), 1).faults, bit(DeviceFault::Frozen));
  EXPECT_EQ(watchdog.judge(true, at_x(0.9000001, 14), 1).faults, 0U);
}

TEST(Watchdog, ADeviceThatSaysNothingOfItselfMayRest) {
  DeviceWatchdog watchdog = watching({});
  for (int tick = 0; tick < 10000; ++tick) {
    EXPECT_EQ(watchdog.judge(true, at_x(0.9, 0), 1).faults, 0U);
  }
}

TEST(Watchdog, IsNotFooledByNumbersThatAreNone) {
  DeviceWatchdog watchdog = watching(living);
  RawDeviceState raw = at_x(0.95, 11);
  raw.world_from_handle.rotation.w = nan;
  const DeviceState state = watchdog.judge(true, raw, 1);
  EXPECT_EQ(state.faults, bit(DeviceFault::NotFinite));
  EXPECT_EQ(state.world_from_handle.translation_um[0], 900);
  EXPECT_EQ(watchdog.last_good().translation_mm.x, 0.9);
}

TEST(Watchdog, SaysOneFaultAtATime) {
  DeviceWatchdog watchdog = watching(living);
  for (int tick = 0; tick < 100; ++tick) {
    // Old, the same and far away: late explains it.
    const std::uint32_t faults = watchdog.judge(true, at_x(500.0, 10), 1).faults;
    EXPECT_EQ(faults & (faults - 1), 0U);
    EXPECT_EQ(faults, tick < 2 ? bit(DeviceFault::Jumped) : bit(DeviceFault::Late)) << tick;
  }
}

/// Where `watching` left it, turned about x by that angle.
RawDeviceState turned(double angle_rad, std::uint64_t packet) {
  RawDeviceState raw = at_x(0.9, packet);
  raw.world_from_handle.rotation = rotation_about({1.0, 0.0, 0.0}, angle_rad);
  return raw;
}

TEST(Watchdog, ATurnThatNoHandMakesIsAJump) {
  for (const double angle_rad : {0.31, 1.0, 3.14159, -0.31}) {
    DeviceWatchdog watchdog = watching(living);
    const DeviceState state = watchdog.judge(true, turned(angle_rad, 11), 1);
    EXPECT_EQ(state.faults, bit(DeviceFault::Jumped)) << angle_rad;
    EXPECT_EQ(state.world_from_handle, quantise(at_x(0.9, 10).world_from_handle));
  }
  for (const double angle_rad : {0.29, -0.29}) {
    DeviceWatchdog watchdog = watching(living);
    EXPECT_EQ(watchdog.judge(true, turned(angle_rad, 11), 1).faults, 0U) << angle_rad;
  }
}

TEST(Watchdog, TheOtherSignOfAQuaternionIsTheSameTurn) {
  DeviceWatchdog watchdog = watching(living);
  RawDeviceState raw = turned(0.01, 11);
  raw.world_from_handle.rotation = -raw.world_from_handle.rotation;
  EXPECT_EQ(watchdog.judge(true, raw, 1).faults, 0U);
}

TEST(Watchdog, ALineOfThreeTicksIsAsFarAsAHandGoesInThree) {
  DeviceWatchdog watchdog = watching(living);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9 + 59.0, 11), 3).faults, 0U);
  EXPECT_EQ(watchdog.judge(true, at_x(0.9 + 59.0 + 61.0, 12), 3).faults, bit(DeviceFault::Jumped));
  DeviceWatchdog turning = watching(living);
  EXPECT_EQ(turning.judge(true, turned(0.89, 11), 3).faults, 0U);
  EXPECT_EQ(turning.judge(true, turned(0.89 + 0.91, 12), 3).faults, bit(DeviceFault::Jumped));
}

TEST(Watchdog, AQuaternionThatIsNoRotationIsNoPose) {
  for (const double length : {0.0, 1.0e-200, 0.49, 2.01, 1.0e200}) {
    DeviceWatchdog watchdog = watching(living);
    RawDeviceState raw = at_x(0.95, 11);
    raw.world_from_handle.rotation *= length;
    EXPECT_EQ(watchdog.judge(true, raw, 1).faults, bit(DeviceFault::NotFinite)) << length;
  }
  for (const double length : {0.51, 1.99}) {
    DeviceWatchdog watchdog = watching(living);
    RawDeviceState raw = at_x(0.95, 11);
    raw.world_from_handle.rotation *= length;
    const DeviceState state = watchdog.judge(true, raw, 1);
    EXPECT_EQ(state.faults, 0U) << length;
    EXPECT_EQ(state.world_from_handle, quantise(at_x(0.95, 11).world_from_handle));
  }
}

TEST(Watchdog, ADeviceThatLeapsAboutIsNeverBelieved) {
  DeviceWatchdog watchdog = watching(living);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const double x_mm = 100.0 + 30.0 * static_cast<double>(i % 3);
    const DeviceState state = watchdog.judge(true, at_x(x_mm, 11 + i), 1);
    EXPECT_EQ(state.faults, bit(DeviceFault::Jumped)) << i;
    EXPECT_EQ(state.world_from_handle.translation_um[0], 900) << i;
  }
}

TEST(Watchdog, AJumpIsBelievedOnceItStaysHoweverTheLinesDivideTheTicks) {
  for (const std::int64_t ticks : {1, 2, 3}) {
    DeviceWatchdog watchdog = watching({});
    // As a hand that moves on where the device came back: 0.2 mm a tick.
    double x_mm = 200.0;
    std::int64_t doubted_ticks = 0;
    while (watchdog.judge(true, at_x(x_mm += 0.2 * static_cast<double>(ticks), 0), ticks).faults !=
           0) {
      ASSERT_LT(doubted_ticks += ticks, 100);
    }
    EXPECT_GE(doubted_ticks, 20) << ticks;
    EXPECT_LT(doubted_ticks, 20 + ticks) << ticks;
    EXPECT_EQ(watchdog.last_good().translation_mm.x, x_mm) << ticks;
  }
}

TEST(Watchdog, AnOlderPacketIsNoNewOne) {
  DeviceWatchdog watchdog = watching(living);
  EXPECT_EQ(watchdog.judge(true, at_x(1.0, 9), 1).faults, 0U);
  EXPECT_EQ(watchdog.judge(true, at_x(1.1, 10), 1).faults, 0U);
  EXPECT_EQ(watchdog.judge(true, at_x(1.2, 8), 1).faults, bit(DeviceFault::Late));
  EXPECT_EQ(watchdog.judge(true, at_x(1.3, 11), 1).faults, 0U);
}

TEST(Watchdog, ADriverThatBeginsAgainAfterItWasLostMayNumberAnew) {
  DeviceWatchdog watchdog = watching(living);
  EXPECT_EQ(watchdog.judge(false, at_x(0.9, 10), 1).faults, bit(DeviceFault::Lost));
  for (std::uint64_t packet = 0; packet < 10; ++packet) {
    const double x_mm = 1.0 + 0.1 * static_cast<double>(packet);
    EXPECT_EQ(watchdog.judge(true, at_x(x_mm, packet), 1).faults, 0U) << packet;
  }
}

}  // namespace
}  // namespace hallux::simulator
