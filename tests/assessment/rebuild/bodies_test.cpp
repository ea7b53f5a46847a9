/// A bar that is sawn in two: its halves moved, wired and screwed, and how they lie then.
#include "assessment/rebuild/bodies.h"

#include <gtest/gtest.h>

#include "simulator/base/units.h"
#include "tests/assessment/rebuild/sawn_bar.h"

namespace hallux::assessment {
namespace {

using simulator::CommandKind;
using tests::pointing;

TEST_F(SawnBar, HasABodyForEachPartWhetherItMovedOrNot) {
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, {}, bone_);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[0].name, "bar");
  EXPECT_EQ(bodies[1].name, "body-2");
  for (const BodyPlacement& placement : placements_of(bodies, bone, {})) {
    EXPECT_EQ(placement.moved_mm, 0.0);
    EXPECT_NEAR(*placement.gap_max_mm, 0.5, 0.01) << "the kerf";
    EXPECT_EQ(*placement.contact_share, 0.0);
    EXPECT_EQ(placement.overlap_max_mm, 0.0);
    EXPECT_FALSE(placement.error_mm) << "the plan moves nothing";
  }
}

TEST_F(SawnBar, APartIsThePlannedFragmentWhoseSizeAndPointItHas) {
  const scenarios::Plan plan = plan_of_the_end();
  lead({0.0, 0.0, 3.0});
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, plan, bone_);
  EXPECT_EQ(bodies[0].name, "bar");
  EXPECT_EQ(bodies[1].name, "end");
  const auto placements = placements_of(bodies, bone, plan);
  EXPECT_NEAR(*placements[1].error_mm, 1.0, 0.02);
  EXPECT_NEAR(*placements[1].error_deg, 0.0, 0.05);
  EXPECT_FALSE(placements[0].error_mm);
}

TEST_F(SawnBar, AWholeBoneIsNoFragmentAlthoughItHoldsItsPoint) {
  scenarios::Plan plan;
  plan.fixation.fragments.push_back({.name = "tip",
                                     .bone = 0,
                                     .holds_in_bone_mm = {-14.0, 0.0, 0.0},
                                     .volume_mm3 = 64.0,
                                     .bone_from_rest = {}});
  const auto bodies = bodies_of(rebuilt(), plan, bone_);
  EXPECT_EQ(bodies[0].name, "bar");
  EXPECT_EQ(bodies[1].name, "body-2");
}

TEST_F(SawnBar, TellsHowFarAHalfWasLedAndWhatTouches) {
  lead({0.0, 0.0, 4.0}, true);
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, {}, bone_);
  const auto placements = placements_of(bodies, bone, {});
  EXPECT_EQ(placements[0].moved_mm, 0.0);
  EXPECT_NEAR(placements[1].moved_mm, length_of(Vec2{4.0, 0.5}), 0.03);
  EXPECT_NEAR(placements[1].turned_deg, 0.0, 0.3);
  EXPECT_NEAR(*placements[1].contact_share, 0.5, 0.03) << "half of the face lies beside the other";
  EXPECT_LT(placements[1].overlap_max_mm, 0.05);
  EXPECT_LT(*placements[1].gap_max_mm, 0.1);
  EXPECT_NEAR(bodies[0].volume_mm3 + bodies[1].volume_mm3 + bone.removed_mm3 + bone.debris_mm3,
              bar_mm3, 1e-6 * bar_mm3);
}

TEST_F(SawnBar, AWireThroughBothEngagesBothAndCrossesTheSkinOnce) {
  lead({0.0, 0.0, 0.0});
  bore(bar_wire, 1.0, 1.0, -8.0);
  leave();
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, {}, bone_);
  const Fixation left = fixation(bone, bodies);
  ASSERT_EQ(left.implants.size(), 1U);
  const PlacedImplant& placed = left.implants[0];
  EXPECT_FALSE(placed.is_screw);
  EXPECT_EQ(placed.engages, (std::vector<std::string>{"bar", "body-2"}));
  EXPECT_EQ(placed.cortices, 1) << "the end of the bar; the sawn faces are no cortex";
  EXPECT_NEAR(placed.entry_in_bone_mm.x, 15.0, 0.01);
  EXPECT_NEAR(placed.entry_in_bone_mm.y, 1.0, 0.01);
  EXPECT_LT(placed.tip_in_bone_mm.x, -7.9);
  EXPECT_EQ(placed.diameter_mm, 1.6);
  EXPECT_EQ(placed.insertions, 1);
  const double depth_mm = 15.0 - placed.tip_in_bone_mm.x - 0.5;
  EXPECT_NEAR(left.holes_mm3, pi * 0.64 * depth_mm, 1.5 + left.holes_bound_mm3);
  EXPECT_EQ(held_by(left, bodies), (std::vector<bool>{false, false})) << "it may turn";
}

TEST_F(SawnBar, AWireThatIsWithdrawnAndSetAgainCountsTwice) {
  lead({0.0, 0.0, 0.0});
  bore(bar_wire, 1.0, 1.0, -8.0);
  leave();
  run_.step({{CommandKind::TakeImplant, 0, 0}});
  run_.glide(pointing({180.0, 1.0, 1.0}, {-1.0, 0.0, 0.0}), 1500);
  run_.hold(10);
  run_.step({{CommandKind::ChooseTool, bar_wire, 0}});
  run_.hold(3);
  bore(bar_wire, -1.0, -1.0, -8.0);
  leave();
  const RebuiltBone bone = rebuilt();
  const Fixation left = fixation(bone, bodies_of(bone, {}, bone_));
  ASSERT_EQ(left.implants.size(), 1U);
  EXPECT_EQ(left.implants[0].insertions, 2);
}

TEST_F(SawnBar, AScrewAcrossBothHoldsThem) {
  lead({0.0, 0.0, 0.0});
  bore(bar_drill, 0.0, 0.0, -10.0);
  draw_out();
  bore(bar_screw, 0.0, 0.0, -8.5);
  leave();
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, {}, bone_);
  const Fixation left = fixation(bone, bodies);
  ASSERT_EQ(left.implants.size(), 1U);
  EXPECT_TRUE(left.implants[0].is_screw);
  EXPECT_EQ(left.implants[0].diameter_mm, 2.7);
  EXPECT_EQ(left.implants[0].engages.size(), 2U);
  EXPECT_EQ(held_by(left, bodies), (std::vector<bool>{true, true}));
}

}  // namespace
}  // namespace hallux::assessment
