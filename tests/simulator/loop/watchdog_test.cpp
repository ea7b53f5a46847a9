#include "simulator/loop/watchdog.h"

#include <gtest/gtest.h>

#include <limits>

namespace hallux::simulator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr DevicePulse living{.flicker_ticks = 2, .numbers_packets = true};

std::uint32_t bit(DeviceFault fault) { return static_cast<std::uint32_t>(fault); }

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

}  // namespace
}  // namespace hallux::simulator
