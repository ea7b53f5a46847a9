/// The blade in its slot, through the whole step: kerfs open only there.
#include <gtest/gtest.h>

#include <memory>

#include <cmath>

#include "simulator/base/units.h"
#include "simulator/contact/blade_probe.h"
#include "tests/simulator/contact/feed_force.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::SimulationRun;

constexpr double top_mm = 10.0;
constexpr double above_mm = top_mm + 1.0;

/// 40 x 20 x 30 of soft bone: the blade is narrower than the bone.
Bone wide_block() { return tests::cancellous_bone(tests::solid_block({40.0, 20.0, 30.0})); }

/// 40 x 4 x 6: one stroke saws it through.
Bone thin_block() {
  return tests::cancellous_bone(tests::moved(tests::solid_block({40.0, 4.0, 6.0}),
                                             {{1.0, 0.0, 0.0, 0.0}, {0.0, top_mm - 2.0, 0.0}}));
}

/// Saws down at a place for a while and withdraws the blade.
void stroke(SimulationRun& run, const Vec3& place_mm, double lean_rad = 0.0) {
  const auto at = [&](double y_mm) { return blade_down({place_mm.x, y_mm, place_mm.z}, lean_rad); };
  run.glide(at(above_mm), 60);
  run.glide(at(place_mm.y), 200);
  run.hold(200);
  run.glide(at(above_mm + 2.0), 60);
  run.hold(20);
}

TEST(ToolInKerf, ADeepTouchFreezesAPlaneWhereTheBladeIs) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({2.0, above_mm, 1.0}, 0.1));
  run.glide(blade_down({2.0, top_mm - 8.0, 1.0}, 0.1), 400);
  const auto frozen = run.events(CutEventKind::PlaneFrozen);
  ASSERT_EQ(frozen.size(), 1U);
  EXPECT_EQ(frozen[0].subject, 0);
  const RigidTransform bone_from_kerf = transform_from(frozen[0].pose);
  EXPECT_NEAR(bone_from_kerf.translation_mm.x, 2.0, 0.002);
  EXPECT_NEAR(bone_from_kerf.translation_mm.y, top_mm - 0.3, 0.12);
  const Vec3 normal = transform_direction(bone_from_kerf, {0.0, 0.0, 1.0});
  EXPECT_NEAR(normal.x, -std::cos(0.1), 1e-5);
}

TEST(ToolInKerf, TheForceSettlesAtWhatTheHandsRateNeeds) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({40.0, 20.0, 6.0}));
  // A stiff spring settles in a fraction of a second.
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}), {}, {.coupling_newton_per_mm = 20.0});
  const double rate_mm_s = 1.0;
  run.glide(blade_down({0.0, above_mm - 3.0, 0.0}), 3000);
  const Engagement engaged{0.0, 13.0 * 10.0 / static_cast<double>(tooth_count)};
  EXPECT_NEAR(run.force_in_bone_newton().y, tests::feed_force_newton(engaged, rate_mm_s, 12000.0),
              0.03);
  EXPECT_NEAR(run.force_in_bone_newton().z, 0.0, 0.03);
}

TEST(ToolInKerf, WithdrawingTheBladeFreesTheTool) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  EXPECT_EQ(run.recording().samples.back().kerf, 0);
  EXPECT_LT(run.bone_from_tool().translation_mm.y, top_mm - 0.3);
  run.glide(blade_down({0.0, above_mm + 1.0, 0.0}), 60);
  run.glide(blade_down({5.0, above_mm + 1.0, 4.0}), 100);
  EXPECT_EQ(run.recording().samples.back().kerf, -1);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.x, 5.0, 0.002);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.z, 4.0, 0.002);
  EXPECT_EQ(run.force_in_bone_newton(), Vec3(0.0, 0.0, 0.0));
}

TEST(ToolInKerf, TheSawMustRunToGoDeeper) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  run.switches = 0;
  const double before_mm = run.bone_from_tool().translation_mm.y;
  run.hold(200);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.y, before_mm, 0.001);
}

TEST(ToolInKerf, BoneAtTheEdgeHoldsTheBladeSideways) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  run.switches = 0;
  run.glide(blade_down({0.0, top_mm - 6.0, 3.0}), 100);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.z, 0.0, 0.15);
  EXPECT_NEAR(run.force_in_bone_newton().z, -6.0, 0.3);
}

TEST(ToolInKerf, TheSlotHoldsTheBladeInItsPlane) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  run.glide(blade_down({1.3, top_mm - 6.0, 0.0}), 100);
  // Beyond 0.1 mm of play two springs in line share the way: 2 / (2 + 10) of it.
  const double offset_mm = 0.1 + (1.3 - 0.1) * 2.0 / 12.0;
  EXPECT_NEAR(run.bone_from_tool().translation_mm.x, offset_mm, 0.005);
}

TEST(ToolInKerf, AHandFeelsTheSlotAsTwoSpringsInLine) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  run.glide(blade_down({1.3, top_mm - 6.0, 0.0}), 100);
  EXPECT_NEAR(run.force_in_bone_newton().x, -(1.3 - 0.3) * 2.0, 0.01);
  // 2 and 10 N/mm: 1.67 N a millimetre beyond the play.
  run.glide(blade_down({2.5, top_mm - 6.0, 0.0}), 100);
  EXPECT_NEAR(run.force_in_bone_newton().x, -2.0 - 1.2 * (20.0 / 12.0), 0.01);
}

TEST(ToolInKerf, ABladeBendsNoFurtherThanTheGreatestForceBendsIt) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  run.switches = 0;
  run.glide(blade_down({31.0, top_mm - 6.0, 0.0}), 1000);
  ASSERT_EQ(run.recording().samples.back().kerf, 0);
  // The play, and 30 N on 10 N/mm.
  EXPECT_NEAR(run.bone_from_tool().translation_mm.x, 0.1 + 3.0, 0.002);
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 1000);
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}, 0.9), 1000);
  const Vec3 normal = transform_direction(run.bone_from_tool(), {0.0, 0.0, 1.0});
  // The play, and a tenth of what nine tenths are at the greatest torque.
  EXPECT_NEAR(std::abs(normal.z), std::sin(0.0087 + 500.0 / 4000.0 / 9.0), 0.001);
}

TEST(ToolInKerf, AHandleThatStandsAcrossThePlaneLeavesTheBladeItsDirection) {
  const Bone bone = thin_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 9.0, 0.0}), 300);
  run.hold(3000);
  ASSERT_EQ(run.events(CutEventKind::Breakthrough).size(), 1U);
  run.switches = 0;
  // Almost along the normal; what is left of it in the plane lies along the tooth line.
  const double aside = 0.01, ahead = std::sqrt(1.0 - aside * aside);
  RigidTransform across = blade_down({0.0, top_mm - 9.0, 0.0});
  across.rotation = rotation_from_axes(Vec3{ahead, 0.0, aside}, Vec3{-aside, 0.0, ahead});
  run.glide(across, 300);
  run.hold(500);
  ASSERT_EQ(run.recording().samples.back().kerf, 0);
  const Vec3 direction = transform_direction(run.bone_from_tool(), {1.0, 0.0, 0.0});
  EXPECT_LT(std::abs(direction.z), 0.3);
}

TEST(ToolInKerf, ASecondStrokeInTheSamePlaneOpensTheSameKerf) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, -6.0});
  stroke(run, {0.05, top_mm - 8.0, 6.0}, 0.004);  // no overlap: within 0.5 degree and 0.1 mm
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 1U);
  EXPECT_GE(run.events(CutEventKind::Contact).size(), 2U);
}

TEST(ToolInKerf, ABladeOverTheSlotIsCapturedByIt) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, -4.0});
  stroke(run, {0.4, top_mm - 8.0, 4.0}, 0.035);  // 2 mm overlap, 0.4 mm and 2 degrees off
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 1U);
}

TEST(ToolInKerf, ACapturedBladeComesToItsSlotAtTwoTenthsOfAMetreASecond) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, -4.0});
  const std::size_t first = run.recording().samples.size();
  stroke(run, {0.6, top_mm - 8.0, 4.0}, 0.08);
  ASSERT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 1U);
  const RigidTransform bone_from_world = inverse(bone.world_from_bone);
  const auto pose_at = [&](std::size_t tick) {
    return bone_from_world * transform_from(run.recording().samples[tick].world_from_tool);
  };
  const auto handle_at = [&](std::size_t tick) {
    return bone_from_world * transform_from(run.recording().tape[tick].device.world_from_handle);
  };
  const double depth_mm = Blade{}.depth_mm;
  double most_mm = 0.0;
  for (std::size_t tick = first; tick < run.recording().samples.size(); ++tick) {
    const ProxyMotion hand = motion_between(handle_at(tick - 1), handle_at(tick));
    const double hand_mm = std::sqrt(glm::dot(hand.translation_mm, hand.translation_mm)) +
                           depth_mm * std::sqrt(glm::dot(hand.rotation_rad, hand.rotation_rad));
    const RigidTransform before = pose_at(tick - 1), after = pose_at(tick);
    const double aside_mm = std::abs(after.translation_mm.x - before.translation_mm.x);
    const Vec3 turned =
        transform_direction(after, {0.0, 0.0, 1.0}) - transform_direction(before, {0.0, 0.0, 1.0});
    // Either may take the whole of it; rounded to a micrometre and a millionth.
    EXPECT_LE(aside_mm, hand_mm + 0.2 + 0.003) << tick;
    EXPECT_LE(depth_mm * std::abs(turned.z), hand_mm + 0.2 + 0.003) << tick;
    if (hand_mm < 0.2) most_mm = std::max(most_mm, aside_mm);
  }
  EXPECT_GT(most_mm, 0.15) << "it was drawn aside";
}

TEST(ToolInKerf, WithoutAnOverlapABladeAsFarOffOpensAKerfOfItsOwn) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, -6.0});
  stroke(run, {0.4, top_mm - 8.0, 6.0}, 0.035);
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 2U);
}

TEST(ToolInKerf, AStrokeThreeMillimetresBesideThePlaneOpensANewKerf) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, 0.0});
  stroke(run, {3.0, top_mm - 8.0, 0.0});
  const auto frozen = run.events(CutEventKind::PlaneFrozen);
  ASSERT_EQ(frozen.size(), 2U);
  EXPECT_EQ(frozen[1].subject, 1);
}

TEST(ToolInKerf, AKerfBeyondTheLimitIsRefusedWithAnEvent) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({-9.0, above_mm, 0.0}));
  for (std::int32_t i = 0; i < kerf_limit; ++i) stroke(run, {1.1 * i - 9.0, top_mm - 8.0, 0.0});
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), static_cast<std::size_t>(kerf_limit));
  EXPECT_EQ(run.events(CutEventKind::KerfRefused).size(), 0U);
  stroke(run, {9.0, top_mm - 8.0, 0.0});
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), static_cast<std::size_t>(kerf_limit));
  EXPECT_GE(run.events(CutEventKind::KerfRefused).size(), 1U);
}

TEST(ToolInKerf, ARefusedKerfIsOneEventAndTheTeethGoNoDeeper) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({-9.0, above_mm, 0.0}));
  for (std::int32_t i = 0; i < kerf_limit; ++i) stroke(run, {1.1 * i - 9.0, top_mm - 8.0, 0.0});
  run.glide(blade_down({9.0, above_mm, 0.0}), 60);
  run.glide(blade_down({9.0, top_mm - 8.0, 0.0}), 1000);
  EXPECT_EQ(run.events(CutEventKind::KerfRefused).size(), 1U);
  EXPECT_GT(run.bone_from_tool().translation_mm.y, top_mm - 0.5);
}

TEST(ToolInKerf, LeavingTheBoneAtTheFarSideIsABreakThrough) {
  const Bone bone = thin_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 12.0, 0.0}), 1500);
  run.hold(500);
  const auto through = run.events(CutEventKind::Breakthrough);
  ASSERT_EQ(through.size(), 1U);
  EXPECT_EQ(through[0].subject, 0);
  // In the tick in which the last bone gives way the stretched spring carries the blade on, at most
  // a millimetre.
  const double tip_y_mm = transform_from(through[0].pose).translation_mm.y;
  EXPECT_LT(tip_y_mm, top_mm - 4.0);
  EXPECT_GT(tip_y_mm, top_mm - 5.1);
}

/// A round bone of 12 mm, wider than a stroke.
Bone round_bone() {
  return tests::cancellous_bone(tests::hollow_tube(
      {.outer_radius_mm = 6.0, .inner_radius_mm = 0.0, .length_mm = 30.0, .segments = 48}));
}

/// A blade over a round bone, so far aside of its middle.
RigidTransform beside_middle(double aside_mm, double tip_mm) {
  return blade_down({0.0, tip_mm, aside_mm});
}

/// The first stroke, from -6 to 3 mm beside the middle, all the way through and out again.
void make_first_stroke(SimulationRun& run) {
  run.glide(beside_middle(-2.0, -8.0), 5000);
  run.hold(2000);
  run.glide(beside_middle(-2.0, 9.0), 500);
  run.glide(beside_middle(4.5, 9.0), 200);
}

TEST(ToolInKerf, EachOfTwoStrokesSideBySideOnARoundBoneBreaksThrough) {
  const Bone bone = round_bone();
  SimulationRun run(bone, beside_middle(-2.0, 8.0));
  make_first_stroke(run);
  ASSERT_EQ(run.events(CutEventKind::Breakthrough).size(), 1U);
  // Its last tooth in bone comes out 5 mm deep; those in the first stroke's kerf are out a
  // millimetre later.
  run.glide(beside_middle(4.5, -8.0), 5000);
  run.hold(2000);
  run.glide(beside_middle(4.5, 9.0), 500);
  ASSERT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 1U);
  const auto through = run.events(CutEventKind::Breakthrough);
  ASSERT_EQ(through.size(), 2U);
  EXPECT_EQ(through[1].subject, 0);
  EXPECT_NEAR(transform_from(through[1].pose).translation_mm.y, -6.0, 0.35);
  EXPECT_EQ(run.events(CutEventKind::PieceFreed).size(), 1U);
}

TEST(ToolInKerf, ATremblingHandBreaksThroughAsWell) {
  const Bone bone = round_bone();
  SimulationRun run(bone, beside_middle(-2.0, 8.0));
  make_first_stroke(run);
  double tip_mm = 8.0;
  for (int i = 0; tip_mm > -8.0; ++i) {
    // A light hand: the spring is slack before the blade is out. 0.2 mm to and fro ten times a
    // second.
    const double tooth_line_mm = run.bone_from_tool().translation_mm.y;
    tip_mm = std::max(tip_mm - 0.004, tooth_line_mm - 0.6);
    run.glide(beside_middle(4.5, tip_mm + (i / 50 % 2 == 0 ? 0.1 : -0.1)), 1);
    ASSERT_LT(i, 60000);
  }
  EXPECT_EQ(run.events(CutEventKind::Breakthrough).size(), 2U);
}

TEST(ToolInKerf, ABladeDrawnBackFromBoneAndLedThroughTheOpenKerfBreaksNothing) {
  const Bone bone = round_bone();
  SimulationRun run(bone, beside_middle(-2.0, 8.0));
  make_first_stroke(run);
  run.glide(beside_middle(4.5, -2.0), 4000);
  ASSERT_TRUE(has(run.recording().samples.back().status, ToolStatus::Cutting));
  ASSERT_LT(run.bone_from_tool().translation_mm.y, 2.0);
  run.glide(beside_middle(4.5, 4.0), 500);
  run.glide(beside_middle(-2.0, 4.0), 500);
  run.glide(beside_middle(-2.0, -8.0), 2000);
  ASSERT_EQ(run.recording().samples.back().kerf, 0) << "never left it";
  EXPECT_LT(run.bone_from_tool().translation_mm.y, -7.5);
  EXPECT_EQ(run.events(CutEventKind::Breakthrough).size(), 1U);
}

TEST(ToolInKerf, ABladeThatSlidesOutSidewaysBreaksNothing) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 10.0}));
  run.glide(blade_down({0.0, top_mm - 8.0, 10.0}), 2000);
  const double tip_mm = run.bone_from_tool().translation_mm.y;
  ASSERT_LT(tip_mm, top_mm - 2.0);
  run.switches = 0;
  run.glide(blade_down({0.0, tip_mm - 0.3, 10.0}), 200);
  run.glide(blade_down({0.0, tip_mm - 4.0, 22.0}), 1000);
  ASSERT_GT(run.bone_from_tool().translation_mm.z, 20.5) << "beside the bone";
  ASSERT_EQ(run.recording().samples.back().kerf, 0) << "and in its plane";
  EXPECT_TRUE(run.events(CutEventKind::Breakthrough).empty());
}

TEST(ToolInKerf, ABladeShorterThanTheSectionNeverBreaksThrough) {
  const Bone bone = wide_block();
  const auto sawn_with = [&](double depth_mm) {
    auto run = std::make_unique<SimulationRun>(bone, blade_down({0.0, above_mm, 0.0}),
                                               Saw{.blade = {.depth_mm = depth_mm}});
    run->glide(blade_down({0.0, -top_mm - 8.0, 0.0}), 6000);
    run->hold(12000);
    return run;
  };
  const auto shorter = sawn_with(15.0);
  EXPECT_TRUE(shorter->events(CutEventKind::Breakthrough).empty());
  EXPECT_NEAR(shorter->bone_from_tool().translation_mm.y, top_mm - 15.0, 0.05);
  EXPECT_GT(shorter->force_in_bone_newton().y, 20.0) << "the collar stands on the bone";
  const auto longer = sawn_with(30.0);
  EXPECT_EQ(longer->events(CutEventKind::Breakthrough).size(), 1U);
}

TEST(ToolInKerf, TheForceDropsAtTheBreakThrough) {
  const Bone bone = thin_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 9.0, 0.0}), 300);
  while (run.events(CutEventKind::Breakthrough).empty() && run.recording().tape.size() < 4000)
    run.hold(1);
  const double before_newton = run.force_in_bone_newton().y;
  run.hold(100);
  EXPECT_GT(before_newton, 5.0);
  EXPECT_LT(run.force_in_bone_newton().y, 0.1);
}

TEST(ToolInKerf, NoForceIsEverAboveTheLimit) {
  const Bone bone = wide_block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({4.0, top_mm - 30.0, 8.0}, 0.3), 500);
  bool was_limited = false;
  for (const ToolSample& sample : run.recording().samples) {
    double square = 0.0;
    for (const std::int32_t part : sample.force_mn) square += static_cast<double>(part) * part;
    EXPECT_LE(std::sqrt(square), 30002.0);
    was_limited = was_limited || has(sample.status, ToolStatus::ForceLimited);
  }
  EXPECT_TRUE(was_limited);
}

}  // namespace
}  // namespace hallux::simulator
