/// Whole attempts with an arm in the hand, in virtual time: what it is given of the simulated force, and how soon nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "simulator/device/force_output.h"
#include "simulator/device/modelled/modelled_arm.h"
#include "simulator/loop/replay.h"
#include "tests/simulator/loop/recorded_run.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 3000;
constexpr std::int64_t fault_tick = 650;  ///< in the midst of the bone; through it is at about 1200

double length(const Vec3& vector) { return std::sqrt(glm::dot(vector, vector)); }

/// An arm whose words are garbled for a while; remembers what it said at each tick and was given.
class GarbledArm final : public HapticDevice {
 public:
  using Garble = std::function<bool(RawDeviceState& state, const RawDeviceState& last_good)>;
  GarbledArm(const HandMotion& motion, const ModelledArmSetup& setup, std::int64_t ticks,
             Garble garble)
      : arm_(motion, setup), end_tick_(fault_tick + ticks), garble_(std::move(garble)) {}

  DeviceDescription description() const override { return arm_.description(); }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override {
    given_newton.push_back(force_in_world_newton);
    arm_.exchange(force_in_world_newton, tick, state);
    least_of_wall_millijoule =
        std::min(least_of_wall_millijoule, -arm_.arm().work.of_motors_millijoule);
    if (tick < fault_tick) last_good_ = state;
    return tick >= fault_tick && tick < end_tick_ ? garble_(state, last_good_) : true;
  }
  const ArmState& arm() const { return arm_.arm(); }

  std::vector<Vec3> given_newton;         ///< at each exchange
  double least_of_wall_millijoule = 0.0;  ///< what the hand had paid in, at its least

 private:
  ModelledArm arm_;
  RawDeviceState last_good_;
  std::int64_t end_tick_;
  Garble garble_;
};

struct ArmAttempt {
  explicit ArmAttempt(GarbledArm::Garble garble, std::int64_t fault_ticks = 60,
                      std::int32_t transport_ticks = 1, std::vector<HandCommand> extra = {},
                      ForceLaw law = ForceLaw::Simulated)
      : device(motion, arm_setup(transport_ticks), fault_ticks, std::move(garble)) {
    extra.insert(extra.begin(), motion.commands.front());
    extra.push_back(motion.commands.back());
    const AttemptSetup setup{.bone = bone,
                             .blade = {},
                             .contact = {},
                             .commands = std::move(extra),
                             .last_tick = last_tick,
                             .job_delay = {},
                             .force_law = law};
    run = tests::record(setup, device);
  }
  static ModelledArmSetup arm_setup(std::int32_t transport_ticks) {
    ModelledArmSetup setup;
    setup.arm.transport_ticks = transport_ticks;
    return setup;
  }
  Vec3 given_newton(std::int64_t tick) const {
    return device.given_newton.at(static_cast<std::size_t>(tick));
  }

  Bone bone = tests::loop_block();
  HandMotion motion = tests::sawing_motion(bone, last_tick);
  GarbledArm device;
  tests::RecordedRun run;
};

bool says_nothing_wrong(RawDeviceState&, const RawDeviceState&) { return true; }

/// In time: what acts on the motors 5 ms after the first wrong word is no force, and stays none until the fault is over. Then
/// it grows again from nothing. The step notes one event.
void expect_let_go(const ArmAttempt& attempt, DeviceFault fault, std::int64_t fault_ticks,
                   std::int32_t transport_ticks) {
  EXPECT_GT(length(attempt.given_newton(fault_tick)), 0.1) << "there was something to let go of";
  for (std::int64_t tick = fault_tick + 5 - transport_ticks; tick < fault_tick + fault_ticks;
       ++tick) {
    EXPECT_EQ(attempt.given_newton(tick), Vec3(0.0, 0.0, 0.0)) << tick;
  }
  double most_newton = 0.0;
  for (std::int64_t tick = 0; tick < 100; ++tick) {
    // A fifth of what 30 N are, and the damper's part at the speed of a hand.
    const Vec3 given_newton = attempt.given_newton(fault_tick + fault_ticks + tick);
    EXPECT_LE(length(given_newton), 0.002 * static_cast<double>(tick + 1) * 30.0 * 0.24 + 2.0);
    most_newton = std::max(most_newton, length(given_newton));
  }
  EXPECT_GT(most_newton, 0.0) << "and it comes back";
  std::vector<CutEvent> faults;
  for (const CutEvent& event : attempt.run.recording.events) {
    if (event.kind == CutEventKind::Fault) faults.push_back(event);
  }
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].value, static_cast<std::int64_t>(fault));
  EXPECT_GE(faults[0].tick, fault_tick);
  EXPECT_LE(faults[0].tick, fault_tick + 2);
  EXPECT_TRUE(replay(attempt.run.recording, {attempt.bone, {}, {}, {}}).is_identical);
}

/// With each transport that an arm may have.
void expect_let_go_of(const GarbledArm::Garble& garble, DeviceFault fault,
                      std::int64_t fault_ticks) {
  for (std::int32_t transport = 0; transport <= 2; ++transport) {
    SCOPED_TRACE(transport);
    expect_let_go(ArmAttempt(garble, fault_ticks, transport), fault, fault_ticks, transport);
  }
}

TEST(ArmFault, SilenceIsNoForceInTime) {
  expect_let_go_of([](RawDeviceState&, const RawDeviceState&) { return false; }, DeviceFault::Lost,
                   60);
}

TEST(ArmFault, NoNumberIsNoForceInTime) {
  expect_let_go_of(
      [](RawDeviceState& state, const RawDeviceState&) {
        state.world_from_handle.translation_mm.x = std::numeric_limits<double>::quiet_NaN();
        return true;
      },
      DeviceFault::NotFinite, 60);
}

TEST(ArmFault, AJumpIsNoForceInTime) {
  expect_let_go_of(
      [](RawDeviceState& state, const RawDeviceState&) {
        state.world_from_handle.translation_mm.x += 100.0;
        return true;
      },
      DeviceFault::Jumped, 15);
}

TEST(ArmFault, APacketThatIsLateIsNoForceInTime) {
  // The driver answers, and each time with the packet that it had.
  expect_let_go_of(
      [](RawDeviceState& state, const RawDeviceState& last_good) {
        state = last_good;
        return true;
      },
      DeviceFault::Late, 60);
}

TEST(ArmFault, AFrozenPoseInFreshPacketsIsNoForceInTime) {
  expect_let_go_of(
      [](RawDeviceState& state, const RawDeviceState& last_good) {
        state.world_from_handle = last_good.world_from_handle;
        return true;
      },
      DeviceFault::Frozen, 60);
}

TEST(ArmFault, APacketTwoTicksLateIsNone) {
  const ArmAttempt attempt(
      [](RawDeviceState& state, const RawDeviceState& last_good) {
        state = last_good;
        return true;
      },
      2);
  for (const CutEvent& event : attempt.run.recording.events) {
    EXPECT_NE(event.kind, CutEventKind::Fault);
  }
}

TEST(ArmAttempt, IsGivenTheScaledForceATickLaterWhereNothingLimitsIt) {
  const ArmAttempt attempt(says_nothing_wrong);
  EXPECT_NEAR(attempt.run.statistics.force_scale, 0.24, 1.0e-12) << "six tenths of 8 N for 20 N";
  const auto& samples = attempt.run.recording.samples;
  std::size_t equal = 0, pushed = 0;
  for (std::size_t i = 600; i + 1 < samples.size(); ++i) {
    const auto& mn = samples[i].force_mn;
    const Vec3 scaled_newton = 0.24 * Vec3(mn[0] / 1000.0, mn[1] / 1000.0, mn[2] / 1000.0);
    if (length(scaled_newton) < 0.1) continue;
    ++pushed;
    if (length(attempt.device.given_newton[i + 1] - scaled_newton) < 1.0e-9) ++equal;
  }
  EXPECT_GT(pushed, 500U);
  EXPECT_GT(equal, pushed * 9 / 10) << "sawing is slow work: hardly anything is limited";
}

TEST(ArmAttempt, SawsThroughAsFeltByAHandAndReplaysToTheSameBits) {
  const ArmAttempt attempt(says_nothing_wrong);
  std::size_t frozen = 0, cut = 0;
  for (const CutEvent& event : attempt.run.recording.events) {
    if (event.kind == CutEventKind::PlaneFrozen) ++frozen;
  }
  for (const ToolSample& sample : attempt.run.recording.samples) {
    if (has(sample.status, ToolStatus::Cutting)) ++cut;
  }
  EXPECT_EQ(frozen, 1U);
  EXPECT_GT(cut, 500U);
  EXPECT_TRUE(replay(attempt.run.recording, {attempt.bone, {}, {}, {}}).is_identical);
}

/// A saw at rest is set on the bone and pressed, again and again: a spring, and nothing that takes its work.
HandMotion knocking(const Bone& bone) {
  HandMotion motion = tests::sawing_motion(bone, last_tick);
  const HandKey above = motion.keys[0], pressed = motion.keys[1];
  motion.keys.clear();
  for (std::int64_t tick = 0; tick < last_tick; tick += 300) {
    motion.keys.push_back({tick, above.world_from_handle, 0});
    motion.keys.push_back({tick + 100, pressed.world_from_handle, 0});
    motion.keys.push_back({tick + 200, pressed.world_from_handle, 0});
  }
  return motion;
}

TEST(ArmAttempt, ItsMotorsNeverDoMoreThanTheHandHasPaid) {
  const Bone bone = tests::loop_block();
  const HandMotion motion = knocking(bone);
  for (std::int32_t transport = 0; transport <= 2; ++transport) {
    GarbledArm device(motion, ArmAttempt::arm_setup(transport), 0, says_nothing_wrong);
    const AttemptSetup setup{.bone = bone,
                             .blade = {},
                             .contact = {},
                             .commands = motion.commands,
                             .last_tick = last_tick,
                             .job_delay = {}};
    tests::record(setup, device);
    // An encoder step at the greatest force.
    EXPECT_GE(device.least_of_wall_millijoule, -0.015 * 8.0) << transport << " ticks of transport";
    EXPECT_GT(length(device.given_newton[2850]), 0.5) << "it was pressed";
  }
}

TEST(ArmAttempt, IsLetGoWhereItEndsInTheMidstOfBone) {
  const ArmAttempt attempt(says_nothing_wrong, 0, 1, {{700, {CommandKind::Finish, 0, 0}}});
  EXPECT_EQ(attempt.run.statistics.end, AttemptEnd::Finished);
  const auto& given = attempt.device.given_newton;
  EXPECT_GT(length(given[699]), 0.1);
  EXPECT_EQ(given.back(), Vec3(0.0, 0.0, 0.0));
}

TEST(ArmAttempt, TheHistoricLawIsFeltAndTheSimulatedForceIsRecorded) {
  const ArmAttempt attempt(says_nothing_wrong, 0, 1, {}, ForceLaw::Historic);
  const auto& samples = attempt.run.recording.samples;
  std::size_t pushed = 0, equal = 0;
  double most_newton = 0.0;
  for (std::size_t i = 500; i + 1 < samples.size(); ++i) {
    const auto& mn = samples[i].force_mn;
    const Vec3 scaled_newton = 0.24 * Vec3(mn[0] / 1000.0, mn[1] / 1000.0, mn[2] / 1000.0);
    const Vec3 given_newton = attempt.device.given_newton[i + 1];
    most_newton = std::max(most_newton, length(given_newton));
    if (length(scaled_newton) < 0.1) continue;
    ++pushed;
    if (length(given_newton - scaled_newton) < 0.05) ++equal;
  }
  EXPECT_GT(pushed, 300U);
  EXPECT_LT(equal, pushed / 2) << "it is another force";
  EXPECT_GT(most_newton, 0.5);
  EXPECT_LE(most_newton, 8.0 + 1.0e-9);
  EXPECT_TRUE(replay(attempt.run.recording, {attempt.bone, {}, {}, {}}).is_identical);
}

TEST(ArmAttempt, HasNoForceBeforeItBeginsWhileItPausesAndAfterItsEnd) {
  const ArmAttempt attempt(says_nothing_wrong, 0, 1,
                           {{650, {CommandKind::Pause, 0, 0}}, {750, {CommandKind::Resume, 0, 0}}});
  const auto& given = attempt.device.given_newton;
  EXPECT_EQ(given[0], Vec3(0.0, 0.0, 0.0));
  EXPECT_GT(length(given[650]), 0.1);
  for (std::size_t tick = 651; tick <= 750; ++tick) {
    EXPECT_EQ(given[tick], Vec3(0.0, 0.0, 0.0)) << tick;
  }
  EXPECT_LT(length(given[770]), 0.1 * length(given[650]) + 0.3) << "softly";
  EXPECT_EQ(given.back(), Vec3(0.0, 0.0, 0.0));
  EXPECT_TRUE(has(attempt.run.statistics.force_limits, ForceLimit::Stopped));
  EXPECT_TRUE(has(attempt.run.statistics.force_limits, ForceLimit::SoftStart));
}

}  // namespace
}  // namespace hallux::simulator
