/// Whole attempts with an arm in the hand, in virtual time: what it is given of the simulated
/// force, and how soon nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/device/force_output.h"
#include "simulator/device/modelled/modelled_arm.h"
#include "simulator/loop/replay.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/loop/watched_device.h"
#include "tests/simulator/step/simulation_run.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 3000;
constexpr std::int64_t fault_tick = 650;  ///< in the midst of the bone; through it is at about 1200

double length(const Vec3& vector) { return std::sqrt(glm::dot(vector, vector)); }

struct ArmAttempt {
  explicit ArmAttempt(tests::Garble garble, std::int64_t fault_ticks = 60,
                      std::int32_t transport_ticks = 1, const std::vector<HandCommand>& extra = {},
                      ForceLaw law = ForceLaw::Simulated)
      : arm(motion, arm_setup(transport_ticks)),
        device(arm, {fault_tick, fault_tick + fault_ticks, std::move(garble)}) {
    AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
    setup.commands.insert(setup.commands.begin() + 1, extra.begin(), extra.end());
    setup.force_law = law;
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
  ModelledArm arm;
  tests::WatchedDevice device;
  tests::RecordedRun run;
};

bool says_nothing_wrong(RawDeviceState&, const RawDeviceState&) { return true; }

/// In time: what acts on the motors 5 ms after the first wrong word is no force, and stays none
/// until the fault is over. Then it grows again from nothing. The step notes one event.
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
void expect_let_go_of(const tests::Garble& garble, DeviceFault fault, std::int64_t fault_ticks) {
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

/// A saw at rest is set on the bone and pressed, again and again: a spring, and nothing that takes
/// its work.
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

/// What the hand has paid in, at its least: below 0, the motors did so much unpaid. All three
/// outlive the attempt.
void watch_motors(tests::WatchedDevice& device, const ModelledArm& arm, double& least_millijoule) {
  device.after_exchange = [&](std::int64_t) {
    least_millijoule = std::min(least_millijoule, -arm.arm().work.of_motors_millijoule);
  };
}

TEST(ArmAttempt, ItsMotorsNeverDoMoreThanTheHandHasPaid) {
  const Bone bone = tests::loop_block();
  const HandMotion motion = knocking(bone);
  for (std::int32_t transport = 0; transport <= 2; ++transport) {
    ModelledArm arm(motion, ArmAttempt::arm_setup(transport));
    tests::WatchedDevice device(arm);
    double least_of_wall_millijoule = 0.0;
    watch_motors(device, arm, least_of_wall_millijoule);
    const AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
    tests::record(setup, device);
    // An encoder step at the greatest force.
    EXPECT_GE(least_of_wall_millijoule, -0.015 * 8.0) << transport << " ticks of transport";
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
  const ArmAttempt attempt(says_nothing_wrong, 0, 1, {}, ForceLaw::Thesis);
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

/// An arm held in air with the blade 6 mm beside the planned plane, which leads it like a slot.
struct LedArm {
  explicit LedArm(const ModelledArmSetup& held, ForceLaw law = ForceLaw::Simulated)
      : arm(motion, held), device(arm) {
    AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
    setup.simulation.contact = contact;
    setup.force_law = law;
    watch_motors(device, arm, least_of_wall_millijoule);
    run = tests::record(setup, device);
    for (const TapeLine& line : run.recording.tape) {
      const RigidTransform bone_from_handle =
          inverse(bone.world_from_bone) * transform_from(line.device.world_from_handle);
      off_mm.push_back(bone_from_handle.translation_mm.x - plane_mm);
    }
  }
  /// Its hand does not tremble: what moves is the loop's.
  static ModelledArmSetup held_arm(std::int32_t transport_ticks, double grip_newton_per_mm) {
    ModelledArmSetup setup = ArmAttempt::arm_setup(transport_ticks);
    setup.hand.stiffness_newton_per_mm = grip_newton_per_mm;
    setup.hand.tremor_mm = 0.0;
    return setup;
  }
  static HandMotion held_in_air(const Bone& bone) {
    const RigidTransform held =
        bone.world_from_bone * tests::blade_down({plane_mm + start_mm, 10.0, 0.0});
    return {
        .keys = {{0, held, 0}, {last_tick, held, 0}},
        .commands = {{0, {CommandKind::Start, 0, 0}}, {last_tick, {CommandKind::Finish, 0, 0}}}};
  }
  /// Since when it is in the guide's play, but for 0.1 mm: there the guide pushes with 0.03 N, and
  /// it nears ever more slowly.
  std::int64_t led_tick() const {
    const auto in_play = std::find_if(off_mm.begin(), off_mm.end(),
                                      [](double mm) { return mm <= guide_play_mm + 0.1; });
    return in_play - off_mm.begin();
  }
  double greatest_speed_mm_s() const {
    double greatest_mm = 0.0;  // in ten ticks: an encoder step is 15 mm/s in one
    for (std::size_t i = 10; i < off_mm.size(); ++i) {
      greatest_mm = std::max(greatest_mm, std::abs(off_mm[i] - off_mm[i - 10]));
    }
    return 100.0 * greatest_mm;
  }
  /// Between the most and the least of the last half second before the end, where it is let go.
  double range_at_rest_mm() const {
    const auto [least, most] = std::minmax_element(off_mm.end() - 500, off_mm.end() - 1);
    return *most - *least;
  }

  static constexpr double plane_mm = -1.0, start_mm = 6.0;
  /// Of the arm: six tenths of the coupling's 2 N/mm, scaled by 0.24.
  static constexpr double stiffness_newton_per_mm = 0.24 * guide_share_of_stiffness * 2.0;

  ContactSettings contact = {
      .guide = {Guidance::Slot, {GuidePlane{Vec3(1.0, 0.0, 0.0), plane_mm}}}};
  Bone bone = tests::loop_block();
  HandMotion motion = held_in_air(bone);
  ModelledArm arm;
  tests::WatchedDevice device;
  double least_of_wall_millijoule = 0.0;
  tests::RecordedRun run;
  std::vector<double> off_mm;  ///< beside the plane, a value a tick
};

/// What the guide's spring holds where the hand is 6 mm off.
constexpr double held_millijoule = 0.5 * LedArm::stiffness_newton_per_mm *
                                   (LedArm::start_mm - guide_play_mm) *
                                   (LedArm::start_mm - guide_play_mm);

TEST(GuidedArm, LooselyHeldComesIntoThePlayAndRestsThere) {
  for (std::int32_t transport = 0; transport <= 2; ++transport) {
    const LedArm led(LedArm::held_arm(transport, 0.0));
    EXPECT_LT(led.led_tick(), 1000) << transport;
    EXPECT_GT(*std::min_element(led.off_mm.begin(), led.off_mm.end()), 0.0) << "and not through it";
    EXPECT_LT(led.range_at_rest_mm(), 0.1) << transport;
    // The guide came in by itself: its own spring is what the motors may do, and an encoder step at
    // the greatest force.
    EXPECT_GE(led.least_of_wall_millijoule, -held_millijoule - 0.015 * 8.0) << transport;
    EXPECT_TRUE(replay(led.run.recording, {led.bone, {}, led.contact, {}}).is_identical);
  }
}

TEST(GuidedArm, ItsControllerLetsItComeHalfAsFast) {
  // Nobody has paid for a guide that comes in by itself: what it does is what the damper leaves.
  ModelledArmSetup undamped = LedArm::held_arm(1, 0.0);
  undamped.limits.damping_newton_s_per_mm = 0.0;
  const LedArm with(LedArm::held_arm(1, 0.0)), without(undamped);
  EXPECT_TRUE(has(with.run.statistics.force_limits, ForceLimit::Passivity));
  EXPECT_FALSE(has(without.run.statistics.force_limits, ForceLimit::Passivity));
  EXPECT_LT(with.greatest_speed_mm_s(), 0.6 * without.greatest_speed_mm_s());
  EXPECT_GT(with.least_of_wall_millijoule, 0.6 * without.least_of_wall_millijoule);
  EXPECT_GT(with.led_tick(), without.led_tick() + 200);
}

TEST(GuidedArm, HeldFastIsDrawnAsideAndRestsWhereTheForcesAreEqual) {
  constexpr double grip = 0.3;
  constexpr double stiffness = LedArm::stiffness_newton_per_mm;
  const double equal_mm =
      (grip * LedArm::start_mm + stiffness * guide_play_mm) / (grip + stiffness);
  for (std::int32_t transport = 0; transport <= 2; ++transport) {
    const LedArm led(LedArm::held_arm(transport, grip));
    EXPECT_NEAR(led.off_mm.back(), equal_mm, 0.02 * LedArm::start_mm) << transport;
    EXPECT_LT(led.range_at_rest_mm(), 0.1) << transport;
    EXPECT_GE(led.least_of_wall_millijoule, -held_millijoule - 0.015 * 8.0) << transport;
  }
}

TEST(GuidedArm, FeelsNothingInAirUnderTheHistoricLaw) {
  // The guide is no surface, and that law knows surfaces only.
  const LedArm led(LedArm::held_arm(1, 0.3), ForceLaw::Thesis);
  const auto is_pushed = [](const ToolSample& sample) { return sample.force_mn[0] != 0; };
  const auto& samples = led.run.recording.samples;
  EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), is_pushed)) << "the step was guided";
  for (const Vec3& given_newton : led.device.given_newton) {
    ASSERT_EQ(given_newton, Vec3(0.0, 0.0, 0.0));
  }
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
