/// What the loop makes of a device that misbehaves, and what it sends to one that does not.
#include <gtest/gtest.h>

#include <limits>

#include "simulator/record/sample_force.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/loop/watched_device.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 500;
constexpr std::int64_t fault_tick = 200;
constexpr std::int64_t fault_ticks = 10;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct FaultyAttempt {
  explicit FaultyAttempt(tests::Garble garble, std::int64_t garbled_ticks = fault_ticks)
      : device(hand, {fault_tick, fault_tick + garbled_ticks, std::move(garble)}) {
    const AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
    recording = tests::record(setup, device).recording;
  }
  const ToolSample& sample(std::int64_t tick) const {
    return recording.samples.at(static_cast<std::size_t>(tick));
  }

  Bone bone = tests::loop_block();
  HandMotion motion = tests::sawing_motion(bone, last_tick);
  ScriptedDevice hand{motion};
  tests::WatchedDevice device;
  Recording recording;
};

/// While the fault lasts: the last good pose, no force, the tool where it was; one event with its
/// bit; then on again.
void expect_safe(const FaultyAttempt& attempt, DeviceFault fault) {
  const auto bits = static_cast<std::uint32_t>(fault);
  const auto& tape = attempt.recording.tape;
  const auto& good = tape.at(fault_tick - 1).device.world_from_handle;
  for (std::int64_t tick = fault_tick; tick < fault_tick + fault_ticks; ++tick) {
    const TapeLine& line = tape.at(static_cast<std::size_t>(tick));
    EXPECT_EQ(line.device.faults, bits);
    EXPECT_EQ(line.device.world_from_handle, good);
    EXPECT_EQ(attempt.sample(tick).force_mn, (std::array<std::int32_t, 3>{0, 0, 0}));
    EXPECT_EQ(attempt.sample(tick).world_from_tool, attempt.sample(fault_tick - 1).world_from_tool);
  }
  std::vector<CutEvent> faults;
  for (const CutEvent& event : attempt.recording.events) {
    if (event.kind == CutEventKind::Fault) faults.push_back(event);
  }
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].tick, fault_tick);
  EXPECT_EQ(faults[0].value, bits);
  EXPECT_EQ(tape.at(fault_tick + fault_ticks).device.faults, 0U);
  EXPECT_NE(attempt.sample(fault_tick + fault_ticks).force_mn,
            (std::array<std::int32_t, 3>{0, 0, 0}));
}

/// The first line with that command of the loop; -1: none.
std::int64_t tick_of(const Recording& recording, CommandKind kind) {
  for (const TapeLine& line : recording.tape) {
    for (std::size_t i = 0; i < line.command_count; ++i) {
      const Command& command = line.commands[i];
      if (command.kind == kind && command.argument == paused_by_loop) return line.tick;
    }
  }
  return -1;
}

TEST(LoopDevice, ADeviceThatIsGoneForLongerPausesTheAttemptUntilItIsThere) {
  const auto gone = [](RawDeviceState&, const RawDeviceState&) { return false; };
  const FaultyAttempt briefly(gone, 200);
  EXPECT_EQ(tick_of(briefly.recording, CommandKind::Pause), -1);
  const FaultyAttempt longer(gone, 250);
  EXPECT_EQ(tick_of(longer.recording, CommandKind::Pause), fault_tick + 200);
  EXPECT_EQ(tick_of(longer.recording, CommandKind::Resume), fault_tick + 250);
  EXPECT_FALSE(has(longer.sample(fault_tick + 240).status, ToolStatus::Running));
  EXPECT_TRUE(has(longer.sample(fault_tick + 251).status, ToolStatus::Running));
}

TEST(LoopDevice, ALostDeviceIsAFaultWithTheLastGoodPose) {
  expect_safe(FaultyAttempt([](RawDeviceState&, const RawDeviceState&) { return false; }),
              DeviceFault::Lost);
}

TEST(LoopDevice, APositionThatIsNoNumberIsAFault) {
  const FaultyAttempt attempt([](RawDeviceState& state, const RawDeviceState&) {
    state.world_from_handle.translation_mm.y = nan;
    return true;
  });
  expect_safe(attempt, DeviceFault::NotFinite);
}

TEST(LoopDevice, ARotationThatIsNoNumberIsAFault) {
  const FaultyAttempt attempt([](RawDeviceState& state, const RawDeviceState&) {
    state.world_from_handle.rotation.x = std::numeric_limits<double>::infinity();
    return true;
  });
  expect_safe(attempt, DeviceFault::NotFinite);
}

bool jump_aside(RawDeviceState& state, const RawDeviceState&) {
  state.world_from_handle.translation_mm.x += 100.0;
  return true;
}

TEST(LoopDevice, AShortJumpIsAFault) {
  expect_safe(FaultyAttempt(jump_aside), DeviceFault::Jumped);
}

TEST(LoopDevice, AJumpThatStaysIsBelievedInTheEnd) {
  const FaultyAttempt attempt(jump_aside, last_tick);
  const TapeLine& first = attempt.recording.tape.at(fault_tick);
  const TapeLine& later = attempt.recording.tape.at(fault_tick + 50);
  EXPECT_EQ(first.device.faults, static_cast<std::uint32_t>(DeviceFault::Jumped));
  EXPECT_EQ(later.device.faults, 0U);
  EXPECT_NEAR(later.device.world_from_handle.translation_um[0] -
                  first.device.world_from_handle.translation_um[0],
              100000, 2000);
}

TEST(LoopDevice, ItsPoseIsRoundedBeforeTheStepSeesIt) {
  const FaultyAttempt attempt([](RawDeviceState&, const RawDeviceState&) { return true; });
  ScriptedDevice hand(attempt.motion);
  for (const TapeLine& line : attempt.recording.tape) {
    RawDeviceState raw;
    hand.exchange({0.0, 0.0, 0.0}, line.tick, raw);
    EXPECT_EQ(line.device.world_from_handle, quantise(raw.world_from_handle));
  }
}

TEST(LoopDevice, IsSentTheForceOfTheStepBefore) {
  const FaultyAttempt attempt([](RawDeviceState&, const RawDeviceState&) { return true; });
  ASSERT_EQ(attempt.device.given_newton.size(), attempt.recording.samples.size());
  bool was_pushed = false;
  for (std::size_t i = 1; i < attempt.recording.samples.size(); ++i) {
    const Vec3 expected_newton = force_newton(attempt.recording.samples[i - 1]);
    EXPECT_EQ(attempt.device.given_newton[i], expected_newton);
    was_pushed = was_pushed || expected_newton.y != 0.0;
  }
  EXPECT_TRUE(was_pushed);
}

/// An arm that is gone after a while, and a pointer that takes over where it was.
class HandedOver final : public HapticDevice {
 public:
  static constexpr std::int64_t gone_tick = 150, over_tick = 200;

  explicit HandedOver(const HandMotion& motion) : hand_(motion) {}

  DeviceDescription description() const override {
    DeviceLimits limits;
    limits.force_newton = limits.continuous_force_newton = 8.0;
    limits.stiffness_newton_per_mm = 2.0;
    limits.force_scale = 0.2;
    DeviceDescription described{"arm", "arm3", limits};
    described.pulse.numbers_packets = true;
    return described;
  }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override {
    given_newton.push_back(force_in_world_newton);
    static_cast<void>(hand_.exchange(force_in_world_newton, tick, state));
    if (tick < gone_tick) state.packet = static_cast<std::uint64_t>(tick);
    state.is_handed_over = tick >= over_tick;
    return tick < gone_tick || tick >= over_tick;
  }

  std::vector<Vec3> given_newton;

 private:
  ScriptedDevice hand_;
};

TEST(LoopDevice, WhoTakesOverFromALostArmNumbersNothingAndFeelsTheForceAsItIs) {
  const Bone bone = tests::loop_block();
  const HandMotion motion = tests::sawing_motion(bone, last_tick);
  const AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
  HandedOver device(motion);
  const tests::RecordedRun run = tests::record(setup, device);
  EXPECT_TRUE(run.statistics.has_changed_device);
  EXPECT_EQ(run.statistics.force_scale, 0.2) << "of the arm";
  EXPECT_EQ(run.statistics.faulted_ticks, HandedOver::over_tick - HandedOver::gone_tick);
  bool was_pushed = false;
  for (std::size_t tick = HandedOver::over_tick + 1; tick < run.recording.samples.size(); ++tick) {
    const Vec3 expected_newton = force_newton(run.recording.samples[tick - 1]);
    EXPECT_EQ(device.given_newton[tick], expected_newton);
    was_pushed = was_pushed || expected_newton.y != 0.0;
  }
  EXPECT_TRUE(was_pushed);
}

}  // namespace
}  // namespace hallux::simulator
