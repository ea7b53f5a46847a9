/// The kick: when teeth catch, what the hand is given for it, and what it is not.
#include "simulator/contact/kick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/record/sample_force.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::SimulationRun;

constexpr double top_mm = 10.0;
constexpr double side_mm = 15.0;

TEST(Kick, IsTheSameImpulseHoweverTheTimeIsDivided) {
  for (const double duration_s : {0.001, 0.002, 0.003}) {
    KickState kick;
    ASSERT_TRUE(begin_kick(kick, -1.0));
    double impulse_newton_s = 0.0;
    for (double time_s = 0.0; time_s < 0.05; time_s += duration_s) {
      const double newton = kick_newton(kick, duration_s);
      EXPECT_LE(newton, 0.0);
      EXPECT_GE(newton, -kick_peak_newton);
      impulse_newton_s += duration_s * newton;
    }
    EXPECT_NEAR(impulse_newton_s, -0.08, 1.0e-12) << duration_s;
  }
}

TEST(Kick, DoesNotComeAgainWithinAFifthOfASecond) {
  KickState kick;
  ASSERT_TRUE(begin_kick(kick, 1.0));
  int ticks = 0;
  for (; ticks < 1000 && !begin_kick(kick, 1.0); ++ticks) kick_newton(kick, 0.001);
  EXPECT_NEAR(ticks, 200, 1);
}

TEST(Corner, IsTeethAtOneEndAloneOverLessThanTwoMillimetres) {
  constexpr Tissue bone = Tissue::Cortical, soft = Tissue::Cancellous, none = Tissue::None;
  EXPECT_TRUE(is_corner(std::array{bone, none, none, none}, 1.0));
  EXPECT_TRUE(is_corner(std::array{none, none, none, soft}, 1.9));
  EXPECT_FALSE(is_corner(std::array{bone, none, none, none}, 2.0));
  EXPECT_FALSE(is_corner(std::array{bone, soft, none, none}, 1.0));
  EXPECT_FALSE(is_corner(std::array{none, bone, none, none}, 1.0)) << "not at the end";
  EXPECT_FALSE(is_corner(std::array{bone, none, none, bone}, 0.5)) << "both ends";
  EXPECT_FALSE(is_corner(std::array{none, none, none, none}, 1.0));
  EXPECT_FALSE(is_corner(std::array{Tissue::Marrow, none, none, none}, 1.0));
}

TEST(Kick, GoesAwayFromTheBoneThatCaughtIt) {
  constexpr Tissue bone = Tissue::Cortical, none = Tissue::None;
  EXPECT_EQ(side_away_from(std::array{bone, none, none}), 1.0);
  EXPECT_EQ(side_away_from(std::array{none, bone, bone}), -1.0);
  EXPECT_EQ(side_away_from(std::array{bone, bone, bone}), 1.0) << "none is nearer";
}

Bone block() { return tests::cortical_bone(tests::solid_block({40.0, 20.0, 2.0 * side_mm})); }

/// Forces along the tooth line over the next ticks, the hand held still [N].
std::vector<double> forces_along_teeth(SimulationRun& run, int ticks) {
  std::vector<double> forces;
  for (int i = 0; i < ticks; ++i) {
    run.hold(1);
    forces.push_back(run.force_in_bone_newton().z);
  }
  return forces;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

/// The cause of the only kick so far, None without one.
KickCause kicked(const SimulationRun& run) {
  const auto kicks = run.events(CutEventKind::Kick);
  EXPECT_LE(kicks.size(), 1U);
  return kicks.empty() ? KickCause::None : static_cast<KickCause>(kicks[0].subject);
}

TEST(KickedHand, WhereTheSawIsStartedWhileItsTeethStandOnBone) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 2.0, 0.0}));
  run.switches = 0;
  run.glide(blade_down({0.0, top_mm - 2.0, 0.0}), 200);
  ASSERT_EQ(kicked(run), KickCause::None) << "a blade at rest catches nothing";
  run.switches = tests::saw_runs;
  const std::vector<double> forces = forces_along_teeth(run, 60);
  EXPECT_EQ(kicked(run), KickCause::StartedInBone);
  const auto kick = run.events(CutEventKind::Kick).front();
  EXPECT_EQ(kick.value, 80) << "mN s";
  EXPECT_EQ(kick.tick, 201);
  EXPECT_NEAR(transform_from(kick.pose).translation_mm.y, top_mm, 0.05);
  // Each tick within the record's quantum and half a micrometre of the spring: 1.5 mN.
  EXPECT_NEAR(0.001 * std::abs(sum_of(forces)), kick_impulse_newton_s, 1.0e-4);
  EXPECT_NEAR(std::abs(forces[9]), kick_peak_newton, 0.05);
  EXPECT_NEAR(forces[21], 0.0, 0.002) << "and it is over";
  EXPECT_NEAR(run.force_in_bone_newton().y, 2.0 * 2.0, 0.5) << "the push is as it was";
}

TEST(KickedHand, WhereTheBladeMeetsBoneWithACorner) {
  const Bone bone = block();
  for (const double side : {1.0, -1.0}) {
    const double along_mm = side * (side_mm + 5.0 - 1.0);
    SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, along_mm}));
    run.glide(blade_down({0.0, top_mm - 1.0, along_mm}), 100);
    const std::vector<double> forces = forces_along_teeth(run, 40);
    EXPECT_EQ(kicked(run), KickCause::Corner);
    const CutEvent kick = run.events(CutEventKind::Kick).front();
    EXPECT_EQ(kick.tick, run.events(CutEventKind::Contact).front().tick);
    double most_newton = 0.0;
    for (const ToolSample& sample : run.recording().samples) {
      const Vec3 newton = transform_direction(inverse(bone.world_from_bone), force_newton(sample));
      most_newton = std::max(most_newton, side * newton.z);
    }
    EXPECT_NEAR(most_newton, kick_peak_newton, 0.3) << "away from the bone";
  }
}

/// Lowered with a running saw until it touches.
KickCause kick_of_touch(const RigidTransform& bone_from_handle) {
  const Bone bone = block();
  RigidTransform above = bone_from_handle;
  above.translation_mm.y += 4.0;
  RigidTransform below = bone_from_handle;
  below.translation_mm.y -= 1.0;
  SimulationRun run(bone, above);
  run.glide(below, 400);
  EXPECT_EQ(run.events(CutEventKind::Contact).size(), 1U);
  return kicked(run);
}

TEST(KickedHand, IsNoneWhereMoreOfTheTeethMeetBone) {
  EXPECT_EQ(kick_of_touch(blade_down({0.0, top_mm, 0.0})), KickCause::None);
  EXPECT_EQ(kick_of_touch(blade_down({0.0, top_mm, side_mm + 5.0 - 2.5})), KickCause::None);
}

TEST(KickedHand, IsNoneWhereTheBladeIsLaidOnALittleAslantAndOneWhereMuch) {
  const auto aslant = [](double angle_rad) {
    RigidTransform pose = blade_down({0.0, top_mm + 5.0 * angle_rad, 0.0});
    pose.rotation = normalised(rotation_about(Vec3{1.0, 0.0, 0.0}, angle_rad) * pose.rotation);
    return pose;
  };
  EXPECT_EQ(kick_of_touch(aslant(0.08)), KickCause::None);
  EXPECT_EQ(kick_of_touch(aslant(0.25)), KickCause::Corner);
}

TEST(KickedHand, OfASawAtRestIsNoneAtACorner) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, side_mm + 4.0}));
  run.switches = 0;
  run.glide(blade_down({0.0, top_mm - 1.0, side_mm + 4.0}), 100);
  EXPECT_EQ(run.events(CutEventKind::Contact).size(), 1U);
  EXPECT_EQ(kicked(run), KickCause::None);
}

TEST(KickedHand, InTheSlotOnlyWhereTheTeethArePressedOnBone) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({40.0, 20.0, 30.0}));
  SimulationRun run(bone, blade_down({0.0, top_mm + 0.5, 0.0}));
  run.glide(blade_down({0.0, top_mm - 5.0, 0.0}), 3000);
  const double tip_mm = run.bone_from_tool().translation_mm.y;
  run.switches = 0;
  run.glide(blade_down({0.0, tip_mm + 1.0, 0.0}), 100);
  run.switches = tests::saw_runs;
  run.hold(50);
  EXPECT_EQ(kicked(run), KickCause::None) << "drawn back from the bone";
  run.switches = 0;
  run.glide(blade_down({0.0, tip_mm - 2.0, 0.0}), 100);
  run.switches = tests::saw_runs;
  run.hold(1);
  EXPECT_EQ(kicked(run), KickCause::StartedInBone);
  EXPECT_TRUE(has(run.recording().samples.back().status, ToolStatus::InKerf));
}

TEST(KickedHand, StaysWithinTheGreatestForce) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 2.0, 0.0}));
  run.switches = 0;
  run.glide(blade_down({0.0, top_mm - 14.9, 0.0}), 300);
  ASSERT_NEAR(run.force_in_bone_newton().y, 29.8, 0.1);
  run.switches = tests::saw_runs;
  bool was_limited = false;
  for (int i = 0; i < 30; ++i) {
    run.hold(1);
    const Vec3 newton = run.force_in_bone_newton();
    EXPECT_LE(std::sqrt(glm::dot(newton, newton)), 30.0 + 0.002);
    was_limited =
        was_limited || has(run.recording().samples.back().status, ToolStatus::ForceLimited);
  }
  EXPECT_TRUE(was_limited);
}

}  // namespace
}  // namespace hallux::simulator
