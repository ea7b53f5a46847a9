/// A kick as a hand feels it: through the mouse's coupling, and through an arm's limits; and in a
/// replay.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/contact/kick.h"
#include "simulator/device/modelled/modelled_arm.h"
#include "simulator/device/mouse.h"
#include "simulator/loop/replay.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/loop/watched_device.h"
#include "tests/simulator/step/simulation_run.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 1000;
constexpr std::int64_t started_tick = 600;

double length(const Vec3& vector) { return std::sqrt(glm::dot(vector, vector)); }

/// Pressed on the bone with the saw at rest, which is then started.
HandMotion started_in_bone(const Bone& bone) {
  HandMotion motion = tests::sawing_motion(bone, last_tick);
  const HandKey above = motion.keys[0], pressed = motion.keys[1];
  motion.keys = {{0, above.world_from_handle, 0},
                 {300, pressed.world_from_handle, 0},
                 {started_tick, pressed.world_from_handle, tests::saw_runs},
                 {last_tick, pressed.world_from_handle, tests::saw_runs}};
  return motion;
}

struct KickedAttempt {
  explicit KickedAttempt(HapticDevice& device) {
    const AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
    recording = tests::record(setup, device).recording;
  }
  std::int64_t kick_tick() const {
    for (const CutEvent& event : recording.events) {
      if (event.kind == CutEventKind::Kick) return event.tick;
    }
    return -1;
  }

  Bone bone = tests::loop_block();
  HandMotion motion = started_in_bone(bone);
  Recording recording;
};

TEST(KickFelt, ReplaysIdenticalAndIsToldOnce) {
  ScriptedDevice device(started_in_bone(tests::loop_block()));
  const KickedAttempt attempt(device);
  const auto kinds = tests::kinds_of(attempt.recording);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), CutEventKind::Kick), 1);
  EXPECT_EQ(attempt.kick_tick(), started_tick);
  const ReplayResult result = replay(attempt.recording, {attempt.bone, {}, {}, {}});
  EXPECT_TRUE(result.is_identical) << result.difference;
}

TEST(KickFelt, ByAnArmWithinItsForceAndSlew) {
  ModelledArm arm(started_in_bone(tests::loop_block()), {});
  tests::WatchedDevice device(arm);
  const KickedAttempt attempt(device);
  const std::int64_t kick_tick = attempt.kick_tick();
  ASSERT_GE(kick_tick, started_tick);
  const Vec3 along_teeth = transform_direction(
      attempt.bone.world_from_bone * tests::blade_down({5.0, 0.0, 0.2}, 0.05), Vec3{0.0, 1.0, 0.0});
  double most_newton = 0.0;
  // Up to the end of the attempt, where the arm is let go at once.
  for (auto tick = static_cast<std::size_t>(kick_tick); tick < last_tick; ++tick) {
    EXPECT_LE(length(device.given_newton[tick]), 8.0 + 1.0e-9);
    const Vec3 change_newton = device.given_newton[tick] - device.given_newton[tick - 1];
    EXPECT_LE(length(change_newton), 0.5 + 1.0e-9) << "500 N/s";
    if (static_cast<std::int64_t>(tick) > kick_tick + 25) continue;
    most_newton = std::max(most_newton, std::abs(glm::dot(device.given_newton[tick], along_teeth)));
  }
  // Scaled by 0.24; what keeps the arm passive takes its part.
  EXPECT_GT(most_newton, 0.4 * 0.24 * kick_peak_newton);
  EXPECT_LT(most_newton, 1.6 * 0.24 * kick_peak_newton);
}

TEST(KickFelt, ByAMouseIsAThrowAsideAndBack) {
  const Bone bone = tests::loop_block();
  const RigidTransform above = tests::blade_down({5.0, 2.0, 0.0});
  const RigidTransform pressed = tests::blade_down({5.0, -2.0, 0.0});
  tests::SimulationRun run(bone, above);
  MouseDevice mouse(bone.world_from_bone * above);
  RawDeviceState state;
  double thrown_mm = 0.0, at_end_mm = 0.0;
  for (std::int64_t tick = 1; tick < 900; ++tick) {
    const std::uint32_t switches = tick < started_tick ? 0U : tests::saw_runs;
    mouse.aim({bone.world_from_bone * pressed, switches, {}});
    const Vec3 force_newton = transform_direction(bone.world_from_bone, run.force_in_bone_newton());
    ASSERT_TRUE(mouse.exchange(force_newton, tick, state));
    run.switches = state.switches;
    const RigidTransform bone_from_hand = inverse(bone.world_from_bone) * state.world_from_handle;
    run.glide(bone_from_hand, 1);
    at_end_mm = std::abs(bone_from_hand.translation_mm.z);
    thrown_mm = std::max(thrown_mm, at_end_mm);
  }
  ASSERT_EQ(run.events(CutEventKind::Kick).size(), 1U);
  EXPECT_GT(thrown_mm, 0.5);
  // The impulse upon the damping alone: what nothing else holds goes so far.
  EXPECT_LT(thrown_mm, kick_impulse_newton_s / HandCoupling{}.damping_newton_s_per_mm);
  EXPECT_LT(at_end_mm, 0.5);
}

}  // namespace
}  // namespace hallux::simulator
