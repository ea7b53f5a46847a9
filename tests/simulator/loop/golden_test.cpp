/// One cut through every tissue at a slant; its outputs must have the same bits on every machine
/// and in every build.
#include <gtest/gtest.h>

#include <algorithm>

#include "simulator/loop/replay.h"
#include "tests/simulator/loop/golden.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

/// A small tube with cortex, cancellous bone and a canal.
Bone tube() {
  Bone bone = tests::cortical_bone(tests::hollow_tube(
      {.outer_radius_mm = 3.0, .inner_radius_mm = 0.0, .length_mm = 24.0, .segments = 24}));
  bone.canal = tests::inside_out(tests::hollow_tube(
      {.outer_radius_mm = 1.3, .inner_radius_mm = 0.0, .length_mm = 18.0, .segments = 16}));
  bone.cortex = CortexLaw{.mid_mm = 0.6, .floor_mm = 0.3, .length_mm = 24.0};
  return bone;
}

/// Where the blade comes out: it is touched.
constexpr DangerCapsule below_the_tube{.from_in_bone_mm = Vec3{-9.0, -7.0, 0.5},
                                       .to_in_bone_mm = Vec3{9.0, -6.5, 2.0},
                                       .radius_mm = 1.1};

/// A leaning stroke that wavers, a second one that finds its slot again, and the piece picked up.
HandMotion wavering_motion(const Bone& bone) {
  const auto key = [&](std::int64_t tick, const Vec3& tip_mm, double lean_rad) {
    return HandKey{tick, bone.world_from_bone * tests::blade_down(tip_mm, lean_rad),
                   tests::saw_runs};
  };
  HandMotion motion;
  motion.keys = {key(0, {3.0, 4.1, 0.3}, 0.11),     key(200, {3.0, -2.3, 0.1}, 0.12),
                 key(700, {3.1, -9.7, 0.7}, 0.13),  key(1500, {2.9, 4.3, -0.2}, 0.10),
                 key(1700, {3.2, -6.1, 0.9}, 0.13), key(3000, {3.1, -14.9, 1.3}, 0.12),
                 key(4300, {3.0, 5.2, 0.4}, 0.11)};
  motion.commands = {{0, {CommandKind::Start, 0, 0}},       {4100, {CommandKind::PickUp, 1, 0}},
                     {4200, {CommandKind::StepDone, 0, 0}}, {4220, {CommandKind::ReopenStep, 0, 0}},
                     {4240, {CommandKind::StepDone, 0, 0}}, {4300, {CommandKind::Finish, 0, 0}}};
  return motion;
}

TEST(Golden, ASlantedCutThroughATubeGivesTheCommittedHashes) {
  const Bone bone = tube();
  const HandMotion motion = wavering_motion(bone);
  const AttemptSetup setup{.simulation = {.bone = bone, .danger_zones = {below_the_tube}},
                           .commands = motion.commands,
                           .last_tick = motion.last_tick()};
  ScriptedDevice device(motion);
  const Recording recording = tests::record(setup, device).recording;
  const auto kinds = tests::kinds_of(recording);
  for (const CutEventKind kind :
       {CutEventKind::PlaneFrozen, CutEventKind::SectionCovered, CutEventKind::Breakthrough,
        CutEventKind::PieceRemoved, CutEventKind::BoneHot, CutEventKind::BoneNecrosis,
        CutEventKind::DangerContact, CutEventKind::DangerLeft, CutEventKind::StepReopened}) {
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), kind), kinds.end()) << static_cast<int>(kind);
  }
  tests::expect_golden(bone, recording, tests::golden_tube);
}

/// Two seconds of a hand that is led: a corner laid on, a saw started on the bone, and a cut begun.
HandMotion catching_motion(const Bone& bone) {
  const auto key = [&](std::int64_t tick, const Vec3& tip_mm, std::uint32_t switches) {
    return HandKey{tick, bone.world_from_bone * tests::blade_down(tip_mm, 0.04), switches};
  };
  HandMotion motion;
  motion.keys = {key(0, {4.7, 4.3, 4.6}, tests::saw_runs),
                 key(250, {4.6, 2.7, 4.6}, 0),
                 key(400, {4.8, 4.1, 0.2}, 0),
                 key(700, {4.7, 1.9, 0.1}, 0),
                 key(800, {4.6, 1.7, 0.2}, tests::saw_runs),
                 key(2000, {4.9, -4.3, 0.4}, 0)};
  motion.commands = {{0, {CommandKind::Start, 0, 0}}, {2000, {CommandKind::Finish, 0, 0}}};
  return motion;
}

TEST(Golden, AGuidedHandWithADullBladeThatKicksInSoftBoneGivesTheCommittedHashes) {
  const Bone bone = tube();
  const HandMotion motion = catching_motion(bone);
  ContactSettings contact{.bone_quality = 0.8};
  contact.guide = {Guidance::Slot, {GuidePlane{Vec3(1.0, 0.0, 0.0), 3.0}}};
  const AttemptSetup setup{.simulation = {bone, Saw{.sharpness = 0.5}, contact},
                           .commands = motion.commands,
                           .last_tick = motion.last_tick()};
  ScriptedDevice device(motion);
  const Recording recording = tests::record(setup, device).recording;
  std::vector<std::int32_t> causes;
  for (const CutEvent& event : recording.events) {
    if (event.kind == CutEventKind::Kick) causes.push_back(event.subject);
  }
  EXPECT_EQ(causes, (std::vector{static_cast<std::int32_t>(KickCause::Corner),
                                 static_cast<std::int32_t>(KickCause::StartedInBone)}));
  const auto is_led = [](const ToolSample& sample) {
    return !has(sample.status, ToolStatus::InContact) && sample.force_mn[0] != 0;
  };
  EXPECT_TRUE(std::any_of(recording.samples.begin(), recording.samples.end(), is_led));
  const auto kinds = tests::kinds_of(recording);
  EXPECT_NE(std::find(kinds.begin(), kinds.end(), CutEventKind::PlaneFrozen), kinds.end());
  tests::expect_golden(bone, recording, tests::golden_guided);
}

}  // namespace
}  // namespace hallux::simulator
