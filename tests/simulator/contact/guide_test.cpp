/// The guide: its law, and how it leads a hand through the step until the teeth have a kerf.
#include "simulator/contact/guide.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/contact/tool_motion.h"
#include "tests/simulator/step/recorded_effects.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::RecordedEffects;
using tests::SimulationRun;

constexpr double top_mm = 10.0;
constexpr GuideStrength full{.stiffness_newton_per_mm = 2.0,
                             .force_limit_newton = 30.0,
                             .torsion_newton_mm_per_rad = 4000.0,
                             .torque_limit_newton_mm = 500.0};
/// x = 3 in the bone; blade_down lies in it at x = 3.
const GuidePlane plane{Vec3(1.0, 0.0, 0.0), 3.0};

double length(const Vec3& vector) { return std::sqrt(glm::dot(vector, vector)); }

GuidePush push_at(double x_mm, double turned_rad, Guidance guidance = Guidance::Slot) {
  RigidTransform pose = blade_down({x_mm, 4.0, 1.0});
  pose.rotation = normalised(rotation_about(Vec3(0.0, 0.0, 1.0), turned_rad) * pose.rotation);
  return guide_push(pose, plane, guidance, full);
}

TEST(Guide, LeavesABladeAloneThatIsWithinHalfAMillimetre) {
  for (const double off_mm : {-0.5, 0.0, 0.49}) {
    EXPECT_EQ(push_at(3.0 + off_mm, 0.0).force_newton, Vec3(0.0, 0.0, 0.0)) << off_mm;
  }
}

TEST(Guide, DrawsBackWithSixTenthsOfTheCouplingAndAThirdOfItWhereSoft) {
  EXPECT_NEAR(push_at(3.0 + 1.5, 0.0).force_newton.x, -1.2 * 1.0, 1.0e-12);
  EXPECT_NEAR(push_at(3.0 - 4.5, 0.0).force_newton.x, 1.2 * 4.0, 1.0e-12);
  EXPECT_NEAR(push_at(3.0 + 1.5, 0.0, Guidance::Soft).force_newton.x, -0.4 * 1.0, 1.0e-12);
  EXPECT_EQ(push_at(3.0 + 1.5, 0.0, Guidance::None).force_newton.x, 0.0);
}

TEST(Guide, PushesWithAtMostThirtyFivePercentOfTheGreatestForce) {
  EXPECT_NEAR(push_at(3.0 + 8.0, 0.0).force_newton.x, -1.2 * 7.5, 1.0e-12);
  EXPECT_NEAR(push_at(3.0 + 50.0, 0.0).force_newton.x, -10.5, 1.0e-12);
  EXPECT_NEAR(push_at(3.0 - 50.0, 0.0, Guidance::Soft).force_newton.x, 10.5, 1.0e-12);
}

TEST(Guide, TurnsTheBladeBackTheShorterWay) {
  EXPECT_EQ(push_at(3.0, 0.017).torque_newton_mm, Vec3(0.0, 0.0, 0.0));
  const double beyond_rad = std::sin(0.05) - 0.0175;
  EXPECT_NEAR(push_at(3.0, 0.05).torque_newton_mm.z, -2400.0 * beyond_rad, 1.0e-9);
  EXPECT_NEAR(push_at(3.0, -0.05).torque_newton_mm.z, 2400.0 * beyond_rad, 1.0e-9);
  EXPECT_NEAR(push_at(3.0, 0.05, Guidance::Soft).torque_newton_mm.z, -800.0 * beyond_rad, 1.0e-9);
  EXPECT_NEAR(push_at(3.0, 0.6).torque_newton_mm.z, -0.35 * 500.0, 1.0e-9);
  // Turned round, the other face of the blade looks along the normal.
  const double pi = 3.14159265358979323846;
  EXPECT_NEAR(push_at(3.0, pi + 0.05).torque_newton_mm.z, -2400.0 * beyond_rad, 1.0e-9);
  EXPECT_NEAR(length(push_at(3.0, 0.5 * pi).torque_newton_mm), 0.35 * 500.0, 1.0e-9);
}

ContactSettings guided_by(Guidance guidance) {
  ContactSettings settings;
  settings.guide = {guidance, {plane, std::nullopt}};
  return settings;
}

Bone block() { return tests::cortical_bone(tests::solid_block({40.0, 20.0, 30.0})); }

TEST(GuidedHand, IsLedInAirAfterHalfASecond) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, top_mm + 3.0, 0.0}), {}, guided_by(Guidance::Slot));
  EXPECT_LT(length(run.force_in_bone_newton()), 0.02) << "it comes in softly";
  run.hold(249);
  EXPECT_NEAR(run.force_in_bone_newton().x, -0.5 * 1.2 * 1.5, 0.005);
  run.hold(250);
  EXPECT_NEAR(run.force_in_bone_newton().x, -1.2 * 1.5, 0.002);
  EXPECT_NEAR(run.force_in_bone_newton().y, 0.0, 0.002);
}

TEST(GuidedHand, OfATiltedBladeIsTurned) {
  const Bone bone = block();
  RigidTransform tilted = blade_down({3.0, top_mm + 8.0, 0.0});
  tilted.rotation = normalised(rotation_about(Vec3(0.0, 0.0, 1.0), 0.05) * tilted.rotation);
  SimulationRun run(bone, tilted, {}, guided_by(Guidance::Slot));
  const StepOutput output = run.hold(600);
  const Vec3 torque_newton_mm =
      transform_direction(inverse(bone.world_from_bone), output.torque_in_world_newton_mm);
  EXPECT_NEAR(torque_newton_mm.z, -2400.0 * (std::sin(0.05) - 0.0175), 0.1);
}

TEST(GuidedHand, GoesFreeWhereNobodyAskedForAGuideOrTheStepHasNone) {
  const Bone bone = block();
  SimulationRun free(bone, blade_down({8.0, top_mm + 3.0, 0.0}), {}, guided_by(Guidance::None));
  free.hold(600);
  EXPECT_EQ(length(free.force_in_bone_newton()), 0.0);
  SimulationRun next(bone, blade_down({8.0, top_mm + 3.0, 0.0}), {}, guided_by(Guidance::Slot));
  next.hold(600);
  EXPECT_GT(length(next.force_in_bone_newton()), 4.0);
  for (const std::int32_t step : {0, 1, 1000000, -5}) {
    next.step({{CommandKind::StepDone, step, 0}});
    next.hold(600);
    EXPECT_EQ(length(next.force_in_bone_newton()), 0.0) << step;
  }
}

TEST(GuidedHand, ComesInAnewWithTheNextStep) {
  const Bone bone = block();
  ContactSettings settings;
  settings.guide = {Guidance::Slot, {plane, GuidePlane{Vec3(1.0, 0.0, 0.0), -3.0}}};
  SimulationRun run(bone, blade_down({3.0, top_mm + 3.0, 0.0}), {}, settings);
  run.hold(600);
  EXPECT_EQ(length(run.force_in_bone_newton()), 0.0);
  run.step({{CommandKind::StepDone, 0, 0}});
  EXPECT_LT(length(run.force_in_bone_newton()), 0.05);
  run.hold(600);
  EXPECT_NEAR(run.force_in_bone_newton().x, -1.2 * 5.5, 0.002);
}

TEST(GuidedHand, IsLedSoftlyAgainAfterAPauseAGapAndAFault) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, top_mm + 3.0, 0.0}), {}, guided_by(Guidance::Slot));
  const auto expect_led_anew = [&](const char* after) {
    EXPECT_LT(length(run.force_in_bone_newton()), 0.05) << after;
    run.hold(600);
    EXPECT_NEAR(run.force_in_bone_newton().x, -1.2 * 1.5, 0.002) << after;
  };
  run.hold(600);
  for (const std::int32_t by : {paused_by_operator, paused_by_loop}) {
    run.step({{CommandKind::Pause, by, 0}});
    run.step({{CommandKind::Resume, by, 0}});
    expect_led_anew(by == paused_by_loop ? "a gap" : "a pause");
  }
  run.faults = static_cast<std::uint32_t>(DeviceFault::Late);
  run.hold(1);
  run.faults = 0;
  run.hold(1);
  expect_led_anew("a fault");
}

TEST(GuidedHand, IsLetGoOnceTheTeethHaveAKerfOfTheirOwn) {
  const Bone bone = block();
  const double off_mm = 5.0;
  SimulationRun guided(bone, blade_down({off_mm, top_mm + 0.5, 0.0}), {},
                       guided_by(Guidance::Slot));
  guided.hold(600);
  EXPECT_NEAR(guided.force_in_bone_newton().x, -1.2 * 1.5, 0.002);
  guided.glide(blade_down({off_mm, top_mm - 4.0, 0.0}), 600);
  guided.hold(1500);
  ASSERT_EQ(guided.events(CutEventKind::PlaneFrozen).size(), 1U);
  EXPECT_NEAR(guided.force_in_bone_newton().x, 0.0, 0.005);
  guided.glide(blade_down({off_mm, top_mm + 5.0, 0.0}), 300);
  guided.hold(600);
  EXPECT_EQ(length(guided.force_in_bone_newton()), 0.0) << "also for its next stroke";
}

TEST(GuidedHand, IsLedToTheStepsOwnKerfForAFurtherPassBesideIt) {
  const Bone bone = block();
  SimulationRun guided(bone, blade_down({5.0, top_mm + 0.5, 0.0}), {}, guided_by(Guidance::Slot));
  guided.glide(blade_down({5.0, top_mm - 4.0, 0.0}), 600);
  guided.hold(1500);
  ASSERT_EQ(guided.events(CutEventKind::PlaneFrozen).size(), 1U);
  guided.glide(blade_down({5.0, top_mm + 5.0, 0.0}), 300);
  guided.glide(blade_down({7.0, top_mm + 5.0, 0.0}), 300);
  guided.hold(600);
  EXPECT_NEAR(guided.force_in_bone_newton().x, -1.2 * 1.5, 0.01);
}

TEST(GuidedHand, BendsNoBladeThatStandsOnBone) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({8.0, top_mm + 0.5, 0.0}), {}, guided_by(Guidance::Slot));
  run.switches = 0;
  run.hold(600);
  run.glide(blade_down({8.0, top_mm - 0.5, 0.0}), 100);
  const StepOutput output = run.hold(200);
  ASSERT_TRUE(has(output.sample.status, ToolStatus::InContact));
  EXPECT_LT(run.force_in_bone_newton().x, -4.0);
  EXPECT_EQ(output.flex.deflection_mm, 0.0);
  const auto bend_mm = [&](bool is_guided) {
    const RecordedEffects follower(bone, run.recording(), {}, is_guided);
    return std::abs(follower.effects().flex().deflection_mm);
  };
  EXPECT_EQ(bend_mm(true), 0.0);
  EXPECT_GT(bend_mm(false), 0.5) << "the same record, as if the blade bore it all";
}

TEST(GuidedHand, LeavesNothingOfItInASampleOfAKerf) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({8.0, top_mm + 0.5, 0.0}), {}, guided_by(Guidance::Slot));
  run.hold(600);
  run.glide(blade_down({8.0, top_mm - 4.0, 0.0}), 600);
  run.hold(1500);
  int in_kerf = 0;
  for (const ToolSample& sample : run.recording().samples) {
    if (!has(sample.status, ToolStatus::InKerf)) continue;
    ++in_kerf;
    const Vec3 force_newton = transform_direction(
        inverse(bone.world_from_bone),
        Vec3(sample.force_mn[0], sample.force_mn[1], sample.force_mn[2]) * 0.001);
    ASSERT_NEAR(force_newton.x, 0.0, 0.05) << "at tick " << sample.tick;
  }
  EXPECT_GT(in_kerf, 100);
}

TEST(GuidedHand, CutsToTheSameBitsWhereItsHandleIsTheSame) {
  const Bone bone = block();
  const auto tool_at_end = [&](Guidance guidance) {
    SimulationRun run(bone, blade_down({5.0, top_mm + 0.5, 0.0}), {}, guided_by(guidance));
    run.glide(blade_down({5.0, top_mm - 6.0, 0.0}), 1500);
    return run.recording().samples.back().world_from_tool;
  };
  EXPECT_EQ(tool_at_end(Guidance::None), tool_at_end(Guidance::Slot))
      << "a guide pushes the hand, and nothing else";
}

TEST(GuidedHand, FeelsAtMostTheGreatestForceOfAll) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({33.0, top_mm + 1.0, 0.0}), {}, guided_by(Guidance::Slot));
  run.switches = 0;
  run.hold(600);
  EXPECT_NEAR(length(run.force_in_bone_newton()), 10.5, 0.002);
  SimulationRun pressed(bone, blade_down({13.0, top_mm + 1.0, 0.0}), {}, guided_by(Guidance::Slot));
  pressed.switches = 0;
  pressed.glide(blade_down({13.0, top_mm - 16.0, 0.0}), 700);
  EXPECT_LE(length(pressed.force_in_bone_newton()), 30.002);
  EXPECT_TRUE(has(pressed.recording().samples.back().status, ToolStatus::ForceLimited));
}

}  // namespace
}  // namespace hallux::simulator
