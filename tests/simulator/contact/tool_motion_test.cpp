#include "simulator/contact/tool_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/contact/blade_probe.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

/// Free motion looks for bone every tenth of a millimetre.
constexpr double look_mm = 0.1;
/// The block's face that the blade comes to.
constexpr double top_mm = 10.0;

/// A block 40 x 20 x 6 of soft bone and a blade above it; the kerfs stay closed.
class SoftBlock {
 public:
  SoftBlock() { tool.bone_from_tool = tests::blade_down({0.0, top_mm + 2.0, 0.0}); }

  ToolOutcome move(const RigidTransform& bone_from_handle, bool saw_runs, int ticks = 1) {
    ToolOutcome outcome;
    for (int i = 0; i < ticks; ++i) {
      outcome = move_tool(tool, {saw, bone_from_handle, saw_runs}, standing_, settings);
    }
    return outcome;
  }
  ToolOutcome move_for(const RigidTransform& bone_from_handle, double duration_s) {
    return move_tool(tool, {saw, bone_from_handle, true, duration_s}, standing_, settings);
  }
  double tip_y_mm() const { return tool.bone_from_tool.translation_mm.y; }

  ToolState tool;
  Saw saw;
  ContactSettings settings;

 private:
  Bone bone_ = tests::cancellous_bone(tests::solid_block({40.0, 20.0, 6.0}));
  TissueMap tissue_{bone_};
  KerfSet kerfs_{{}, bone_.world_from_bone};
  RemainingTissue standing_{tissue_, kerfs_, {}};
};

RigidTransform handle_at(double y_mm, double x_mm = 0.0) {
  return tests::blade_down({x_mm, y_mm, 0.0});
}

TEST(FreeTool, FollowsTheHandWithoutAForce) {
  SoftBlock world;
  const RigidTransform pose = tests::blade_down({3.0, top_mm + 1.4, 0.5}, 0.2);
  const ToolOutcome outcome = world.move(pose, true, 5);
  EXPECT_EQ(world.tool.stage, ToolStage::Free);
  EXPECT_EQ(world.tool.bone_from_tool, pose);
  EXPECT_EQ(outcome.force_in_bone_newton, Vec3(0.0, 0.0, 0.0));
  EXPECT_FALSE(outcome.began_contact);
}

TEST(FreeTool, ComesAfterAHandThatIsFasterThanItIsWalked) {
  SoftBlock world;
  world.move(tests::blade_down({0.0, top_mm + 12.0, 0.0}), true);
  EXPECT_LT(world.tip_y_mm(), top_mm + 4.0);
  world.move(tests::blade_down({0.0, top_mm + 12.0, 0.0}), true, 20);
  EXPECT_EQ(world.tip_y_mm(), top_mm + 12.0);
}

TEST(FreeTool, AFastHandCannotCarryItThroughBone) {
  SoftBlock world;
  world.move(handle_at(-40.0), false, 100);
  EXPECT_EQ(world.tool.stage, ToolStage::Touching);
  EXPECT_NEAR(world.tip_y_mm(), top_mm, look_mm);
}

TEST(TouchingTool, StopsAtTheSurfaceAndPushesBackWithTheSpring) {
  SoftBlock world;
  const ToolOutcome touch = world.move(handle_at(top_mm - 0.05), false, 30);
  EXPECT_FALSE(touch.began_contact);  // it began on an earlier tick
  const ToolOutcome outcome = world.move(handle_at(top_mm - 3.0), false, 10);
  EXPECT_EQ(world.tool.stage, ToolStage::Touching);
  EXPECT_NEAR(world.tip_y_mm(), top_mm, look_mm);
  const double stretch_mm = world.tip_y_mm() - (top_mm - 3.0);
  EXPECT_NEAR(outcome.force_in_bone_newton.y, 2.0 * stretch_mm, 1e-9);
  EXPECT_NEAR(outcome.force_in_bone_newton.x, 0.0, 1e-9);
}

TEST(TouchingTool, DoesNotCutWhileTheSawStandsStill) {
  SoftBlock world;
  world.move(handle_at(top_mm - 3.0), false, 50);
  const double before_mm = world.tip_y_mm();
  const ToolOutcome outcome = world.move(handle_at(top_mm - 10.0), false, 1000);
  EXPECT_NEAR(world.tip_y_mm(), before_mm, 1e-5);
  EXPECT_EQ(outcome.advance_mm, 0.0);
  EXPECT_FALSE(outcome.wants_freeze);
}

TEST(TouchingTool, AdvancesByTheFeedLawOfTheForceOnIt) {
  SoftBlock world;
  world.move(handle_at(top_mm - 3.0), false, 50);
  const double stretch_mm = world.tip_y_mm() - (top_mm - 3.0);
  const ToolOutcome outcome = world.move(handle_at(top_mm - 3.0), true);
  const double rate_mm_s =
      feed_rate_mm_s(outcome.engaged, 2.0 * stretch_mm, world.saw.cycles_per_minute);
  EXPECT_GT(outcome.engaged.cancellous_mm, 6.0);
  EXPECT_NEAR(outcome.advance_mm, rate_mm_s * 0.001, 1e-9);
}

TEST(TouchingTool, ThreeTicksInOneLineAdvanceThreeTimesAsFar) {
  SoftBlock one, three;
  for (SoftBlock* world : {&one, &three}) world->move(handle_at(top_mm - 3.0), false, 50);
  const double single_mm = one.move(handle_at(top_mm - 3.0), true).advance_mm;
  const ToolOutcome triple = three.move_for(handle_at(top_mm - 3.0), 0.003);
  EXPECT_NEAR(triple.advance_mm, 3.0 * single_mm, 1e-12);
}

TEST(TouchingTool, IsDeepEnoughForAKerfAtThreeTenthsOfAMillimetre) {
  SoftBlock world;
  int ticks = 0;
  while (!world.move(handle_at(top_mm - 3.0), true).wants_freeze && ticks < 2000) ++ticks;
  EXPECT_LT(ticks, 2000);
  EXPECT_GE(world.tool.touch_depth_mm, 0.3);
  EXPECT_LT(world.tool.touch_depth_mm, 0.31);
}

TEST(TouchingTool, AShallowTouchEndsAsAScratchOfItsDepth) {
  SoftBlock world;
  world.move(handle_at(top_mm - 3.0), true, 100);
  const double depth_mm = world.tool.scratch_mm;
  EXPECT_GT(depth_mm, 0.05);
  EXPECT_LT(depth_mm, 0.3);
  double scratch_mm = 0.0;
  for (int i = 0; i < 100 && world.tool.stage == ToolStage::Touching; ++i) {
    scratch_mm = world.move(handle_at(top_mm + 1.0), true).scratch_mm;
  }
  EXPECT_EQ(world.tool.stage, ToolStage::Free);
  EXPECT_EQ(scratch_mm, depth_mm);
}

TEST(TouchingTool, SlidesAlongTheSurfaceWithTheHand) {
  SoftBlock world;
  world.move(handle_at(top_mm - 1.0), false, 50);
  world.move(handle_at(top_mm - 1.0, 2.0), false, 10);
  // A push of 1 mm of stretch: while it slides, friction keeps 0.6 x 0.3 of it.
  EXPECT_NEAR(world.tool.bone_from_tool.translation_mm.x, 2.0 - 0.18, 1e-6);
  EXPECT_NEAR(world.tip_y_mm(), top_mm, look_mm);
}

TEST(TouchingTool, TheForceIsLimited) {
  SoftBlock world;
  const ToolOutcome outcome = world.move(handle_at(top_mm - 20.0), false, 50);
  EXPECT_TRUE(outcome.is_force_limited);
  EXPECT_NEAR(outcome.force_in_bone_newton.y, 30.0, 1e-9);
}

}  // namespace
}  // namespace hallux::simulator
