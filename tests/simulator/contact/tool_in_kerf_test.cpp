/// The blade in its slot, through the whole step: kerfs open only there.
#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "simulator/contact/blade_probe.h"
#include "tests/simulator/step/operation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::OperationRun;

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
void stroke(OperationRun& run, const Vec3& place_mm, double lean_rad = 0.0) {
  const auto at = [&](double y_mm) { return blade_down({place_mm.x, y_mm, place_mm.z}, lean_rad); };
  run.glide(at(above_mm), 60);
  run.glide(at(place_mm.y), 200);
  run.hold(200);
  run.glide(at(above_mm + 2.0), 60);
  run.hold(20);
}

TEST(ToolInKerf, ADeepTouchFreezesAPlaneWhereTheBladeIs) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({2.0, above_mm, 1.0}, 0.1));
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
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}), {}, {.coupling_newton_per_mm = 20.0});
  const double rate_mm_s = 1.0;
  run.glide(blade_down({0.0, above_mm - 3.0, 0.0}), 3000);
  const Engagement engaged{0.0, 13.0 * 10.0 / static_cast<double>(tooth_count)};
  EXPECT_NEAR(run.force_in_bone_newton().y, feed_force_newton(engaged, rate_mm_s, 12000.0), 0.03);
  EXPECT_NEAR(run.force_in_bone_newton().z, 0.0, 0.03);
}

TEST(ToolInKerf, WithdrawingTheBladeFreesTheTool) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
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
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  run.switches = 0;
  const double before_mm = run.bone_from_tool().translation_mm.y;
  run.hold(200);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.y, before_mm, 0.001);
}

TEST(ToolInKerf, BoneAtTheEdgeHoldsTheBladeSideways) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  run.switches = 0;
  run.glide(blade_down({0.0, top_mm - 6.0, 3.0}), 100);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.z, 0.0, 0.15);
  EXPECT_NEAR(run.force_in_bone_newton().z, -6.0, 0.3);
}

TEST(ToolInKerf, TheSlotHoldsTheBladeInItsPlane) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 6.0, 0.0}), 600);
  run.glide(blade_down({1.3, top_mm - 6.0, 0.0}), 100);
  // Beyond 0.1 mm of play two springs in line share the way: 2 / (2 + 10) of it.
  const double offset_mm = 0.1 + (1.3 - 0.1) * 2.0 / 12.0;
  EXPECT_NEAR(run.bone_from_tool().translation_mm.x, offset_mm, 0.005);
}

TEST(ToolInKerf, ASecondStrokeInTheSamePlaneOpensTheSameKerf) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, -6.0});
  stroke(run, {0.05, top_mm - 8.0, 6.0}, 0.004);  // no overlap: within 0.5 degree and 0.1 mm
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 1U);
  EXPECT_GE(run.events(CutEventKind::Contact).size(), 2U);
}

TEST(ToolInKerf, ABladeOverTheSlotIsCapturedByIt) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, -4.0});
  stroke(run, {0.4, top_mm - 8.0, 4.0}, 0.035);  // 2 mm overlap, 0.4 mm and 2 degrees off
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 1U);
}

TEST(ToolInKerf, WithoutAnOverlapABladeAsFarOffOpensAKerfOfItsOwn) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, -6.0});
  stroke(run, {0.4, top_mm - 8.0, 6.0}, 0.035);
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), 2U);
}

TEST(ToolInKerf, AStrokeThreeMillimetresBesideThePlaneOpensANewKerf) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  stroke(run, {0.0, top_mm - 8.0, 0.0});
  stroke(run, {3.0, top_mm - 8.0, 0.0});
  const auto frozen = run.events(CutEventKind::PlaneFrozen);
  ASSERT_EQ(frozen.size(), 2U);
  EXPECT_EQ(frozen[1].subject, 1);
}

TEST(ToolInKerf, AKerfBeyondTheLimitIsRefusedWithAnEvent) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({-9.0, above_mm, 0.0}));
  for (std::int32_t i = 0; i < kerf_limit; ++i) stroke(run, {3.0 * i - 9.0, top_mm - 8.0, 0.0});
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), static_cast<std::size_t>(kerf_limit));
  EXPECT_EQ(run.events(CutEventKind::KerfRefused).size(), 0U);
  stroke(run, {9.0, top_mm - 8.0, 0.0});
  EXPECT_EQ(run.events(CutEventKind::PlaneFrozen).size(), static_cast<std::size_t>(kerf_limit));
  EXPECT_GE(run.events(CutEventKind::KerfRefused).size(), 1U);
}

TEST(ToolInKerf, ARefusedKerfIsOneEventAndTheTeethGoNoDeeper) {
  const Bone bone = wide_block();
  OperationRun run(bone, blade_down({-9.0, above_mm, 0.0}));
  for (std::int32_t i = 0; i < kerf_limit; ++i) stroke(run, {3.0 * i - 9.0, top_mm - 8.0, 0.0});
  run.glide(blade_down({9.0, above_mm, 0.0}), 60);
  run.glide(blade_down({9.0, top_mm - 8.0, 0.0}), 1000);
  EXPECT_EQ(run.events(CutEventKind::KerfRefused).size(), 1U);
  EXPECT_GT(run.bone_from_tool().translation_mm.y, top_mm - 0.5);
}

TEST(ToolInKerf, LeavingTheBoneAtTheFarSideIsABreakThrough) {
  const Bone bone = thin_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.glide(blade_down({0.0, top_mm - 12.0, 0.0}), 1500);
  run.hold(500);
  const auto through = run.events(CutEventKind::Breakthrough);
  ASSERT_EQ(through.size(), 1U);
  EXPECT_EQ(through[0].subject, 0);
  // In the tick in which the last bone gives way the stretched spring carries the blade on, at most a millimetre.
  const double tip_y_mm = transform_from(through[0].pose).translation_mm.y;
  EXPECT_LT(tip_y_mm, top_mm - 4.0);
  EXPECT_GT(tip_y_mm, top_mm - 5.1);
}

TEST(ToolInKerf, TheForceDropsAtTheBreakThrough) {
  const Bone bone = thin_block();
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
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
  OperationRun run(bone, blade_down({0.0, above_mm, 0.0}));
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
