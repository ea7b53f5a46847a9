/// What a saw does beside cutting, followed from the records of operations.
#include "simulator/step/tool_effects.h"

#include <gtest/gtest.h>

#include "simulator/base/units.h"
#include "tests/simulator/step/recorded_effects.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::RecordedEffects;
using tests::SimulationRun;

constexpr double top_mm = 5.0;
constexpr std::uint32_t irrigates = static_cast<std::uint32_t>(Switch::Irrigates);

Bone hard_block() { return tests::cortical_bone(tests::solid_block({20.0, 2.0 * top_mm, 6.0})); }
Bone soft_block() { return tests::cancellous_bone(tests::solid_block({20.0, 2.0 * top_mm, 6.0})); }

/// Pushes at about 10 N for ten seconds: the coupling is 2 N/mm, and the teeth go on by less than 3
/// mm.
void push_down(SimulationRun& run) {
  run.glide(blade_down({0.0, top_mm - 5.5, 0.0}), 100);
  run.glide(blade_down({0.0, top_mm - 7.5, 0.0}), 10000);
}

TEST(ToolEffects, ADrySawInHardBoneHeatsTheWallsUntilTheyDie) {
  const Bone bone = hard_block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  push_down(run);
  const RecordedEffects follower(bone, run.recording());
  const HeatSummary& heat = follower.effects().heat().summary();
  EXPECT_GT(heat.hottest_celsius, 80.0);
  EXPECT_GT(heat.hot_s, 5.0);
  EXPECT_GT(heat.necrotic_mm3, 5.0);
  const auto hot = follower.events(CutEventKind::BoneHot);
  const auto dead = follower.events(CutEventKind::BoneNecrosis);
  ASSERT_FALSE(hot.empty());
  ASSERT_FALSE(dead.empty());
  EXPECT_LT(hot[0].tick, dead[0].tick);
  EXPECT_EQ(hot[0].subject, 0);
  EXPECT_GT(hot[0].value, 47000);
  EXPECT_LT(hot[0].value, 52000);
  EXPECT_GE(dead[0].value, 2000);
  // Within the block, in the plane of the saw.
  const Vec3 place_mm = transform_from(hot[0].pose).translation_mm;
  EXPECT_NEAR(place_mm.x, 0.0, 0.05);
  EXPECT_GT(place_mm.y, 0.0);
  EXPECT_LT(place_mm.y, top_mm + 0.5);
  EXPECT_LT(std::abs(place_mm.z), 4.0);
}

TEST(ToolEffects, IrrigationKeepsTheSameCutCool) {
  const Bone bone = hard_block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  run.switches |= irrigates;
  push_down(run);
  const RecordedEffects follower(bone, run.recording());
  EXPECT_LT(follower.effects().heat().summary().hottest_celsius, 40.0);
  EXPECT_TRUE(follower.events().empty());
}

TEST(ToolEffects, BoneCoolsWhileAnotherKerfIsSawn) {
  const Bone bone = hard_block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  push_down(run);
  run.glide(blade_down({0.0, top_mm + 3.0, 0.0}), 300);
  run.glide(blade_down({6.0, top_mm + 3.0, 0.0}), 300);
  run.glide(blade_down({6.0, top_mm - 1.5, 0.0}), 500);
  run.hold(40000);
  const RecordedEffects follower(bone, run.recording());
  ASSERT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 2U);
  const HeatField& heat = follower.effects().heat();
  const HeatSummary& summary = heat.summary();
  EXPECT_EQ(summary.hottest_kerf, 0);
  EXPECT_LT(heat.celsius_at(0, summary.hottest_place_mm), 38.0);
  // The light hand in the other kerf still rubs.
  EXPECT_GT(heat.celsius_at(1, {0.5, 0.5}), 38.0);
}

/// Across the way of the blade, 3 mm below the block.
std::vector<DangerCapsule> tendon_below() {
  return {{{-20.0, -top_mm - 30.0, 0.0}, {20.0, -top_mm - 30.0, 0.0}, 2.0},
          {{-20.0, -top_mm - 4.0, 0.0}, {20.0, -top_mm - 4.0, 0.0}, 1.0}};
}

/// Beside the block, where the edge of the blade stands out of it.
std::vector<DangerCapsule> tendon_beside() {
  return {{{-20.0, top_mm, 5.0}, {20.0, top_mm, 5.0}, 1.0}};
}

TEST(ToolEffects, ABladeThatPlungesBeyondTheBoneTouchesWhatLiesThere) {
  const Bone bone = soft_block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  run.glide(blade_down({0.0, -top_mm - 5.0, 0.0}), 2000);
  run.hold(6000);
  ASSERT_FALSE(run.events(CutEventKind::Breakthrough).empty());
  run.glide(blade_down({0.0, top_mm + 2.0, 0.0}), 2000);
  const RecordedEffects follower(bone, run.recording(), tendon_below());
  const auto touched = follower.events(CutEventKind::DangerContact);
  const auto left = follower.events(CutEventKind::DangerLeft);
  ASSERT_EQ(touched.size(), 1U);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(touched[0].subject, 1);
  EXPECT_LE(touched[0].value, 0);
  EXPECT_LT(touched[0].tick, left[0].tick);
  // The tip stood 5 mm below the block, in the middle of the capsule and beyond: as deep as it can
  // be.
  EXPECT_EQ(left[0].value, -1250);
  const DangerTrack& track = follower.effects().danger().tracks()[1];
  EXPECT_EQ(track.contacts, 1);
  EXPECT_GT(track.contact_s, 2.0);
  EXPECT_GT(follower.effects().danger().tracks()[0].least_mm, 20.0);
}

TEST(ToolEffects, AHandThatLeansBendsTheBladeThatStandsOut) {
  const Bone bone = hard_block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}));
  push_down(run);
  EXPECT_LT(std::abs(RecordedEffects(bone, run.recording()).effects().flex().deflection_mm), 0.02);
  run.glide(blade_down({1.0, top_mm - 7.5, 0.0}), 50);
  const BladeFlex flex = RecordedEffects(bone, run.recording()).effects().flex();
  const Vec3 force_newton = run.force_in_bone_newton();
  const double in_mm = top_mm - run.bone_from_tool().translation_mm.y;
  EXPECT_NEAR(flex.free_length_mm, 20.0 - in_mm, 0.1);
  // The blade's normal is the bone's x, one way or the other.
  const BladeBeam beam{flex.free_length_mm, 10.0, 0.4};
  EXPECT_NEAR(std::abs(flex.deflection_mm), deflection_mm(beam, std::abs(force_newton.x)), 0.005);
  EXPECT_GT(std::abs(flex.deflection_mm), 0.1);
}

TEST(ToolEffects, AThickerBladeBendsLess) {
  const Bone bone = hard_block();
  const auto bent_mm = [&](double thickness_mm) {
    SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}),
                      Saw{.blade = {.thickness_mm = thickness_mm}});
    push_down(run);
    return std::abs(run.glide(blade_down({1.0, top_mm - 7.5, 0.0}), 50).flex.deflection_mm);
  };
  const double thin_mm = bent_mm(0.4);
  EXPECT_GT(thin_mm, 0.1);
  EXPECT_NEAR(thin_mm / bent_mm(0.6), 1.5 * 1.5 * 1.5, 1e-6);
}

TEST(ToolEffects, OfTheStepIsWhatItsRecordTells) {
  const Bone bone = hard_block();
  SimulationRun run(bone, blade_down({0.0, top_mm + 1.0, 0.0}), {}, {}, tendon_beside());
  push_down(run);
  run.glide(blade_down({0.0, top_mm + 3.0, 0.0}), 300);
  run.hold(500);
  const RecordedEffects follower(bone, run.recording(), tendon_beside());
  for (const CutEventKind kind : {CutEventKind::BoneHot, CutEventKind::BoneNecrosis,
                                  CutEventKind::DangerContact, CutEventKind::DangerLeft}) {
    EXPECT_FALSE(run.events(kind).empty()) << static_cast<int>(kind);
    EXPECT_EQ(run.events(kind), follower.events(kind)) << static_cast<int>(kind);
  }
  EXPECT_EQ(run.simulation().effects().heat().summary().hottest_celsius,
            follower.effects().heat().summary().hottest_celsius);
}

TEST(ToolEffects, MoreZonesThanTheLimitAreNotWatched) {
  const std::vector<DangerCapsule> zones(danger_zone_limit + 3);
  const ToolEffects effects({}, {}, zones);
  EXPECT_EQ(effects.danger().tracks().size(), danger_zone_limit);
}

}  // namespace
}  // namespace hallux::simulator
