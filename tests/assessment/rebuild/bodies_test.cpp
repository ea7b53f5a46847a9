/// A bar that is sawn in two: its halves moved, wired and screwed, and how they lie then.
#include "assessment/rebuild/bodies.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "assessment/rebuild/implants.h"
#include "simulator/base/units.h"
#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::assessment {
namespace {

using simulator::CommandKind;
using tests::blade_down;
using tests::pointing;

constexpr double cut_x_mm = 5.0, bar_mm3 = 30.0 * 8.0 * 8.0;
constexpr std::int32_t wire = 1, drill = 2, screw = 3;

simulator::Tray tray() {
  simulator::Screwdriver driver{.screw = simulator::cortical_screws[2]};
  driver.screw.length_mm = 24.0;
  simulator::Drill bit;
  bit.bit.length_mm = 60.0;
  const std::array<simulator::Tool, 3> further{simulator::WireDriver{}, bit, driver};
  return {simulator::Saw{}, further};
}

class SawnBar : public testing::Test {
 protected:
  SawnBar() {
    run_.glide(blade_down({cut_x_mm, -9.0, 0.0}), 2300);
    run_.hold(1500);
    run_.glide(blade_down({cut_x_mm, 30.0, 0.0}), 400);
    run_.hold(20);
  }
  /// Grips the half beyond the cut, leads it by so much, and lets it go.
  void lead(const Vec3& by_mm, bool impacts = false) {
    run_.step({{CommandKind::Grip, 1, 0}});
    run_.hold(3);
    run_.glide(blade_down(Vec3{cut_x_mm, 30.0, 0.0} + by_mm), 400);
    if (impacts) {
      run_.step({{CommandKind::Impact, 0, 0}});
      run_.hold(1200);
    }
    run_.step({{CommandKind::Release, 0, 0}});
    run_.hold(5);
  }
  /// Along the bar, from its end beyond the cut, until the tip is there.
  void bore(std::int32_t tool, double y_mm, double z_mm, double to_x_mm) {
    const auto at = [&](double x_mm) { return pointing({x_mm, y_mm, z_mm}, {-1.0, 0.0, 0.0}); };
    run_.glide(blade_down({30.0, 40.0, 0.0}), 300);
    run_.glide(at(40.0), 400);
    run_.step({{CommandKind::ChooseTool, tool, 0}});
    run_.hold(3);
    run_.glide(at(to_x_mm - 6.0), 5000);
    for (int i = 0; i < 30000 && run_.bone_from_tool().translation_mm.x > to_x_mm; ++i)
      run_.hold(1);
  }
  void draw_out() {
    const Vec3 tip_mm = run_.bone_from_tool().translation_mm;
    run_.glide(pointing({80.0, tip_mm.y, tip_mm.z}, {-1.0, 0.0, 0.0}), 800);
    run_.hold(20);
  }
  void leave() {
    run_.step({{CommandKind::LeaveImplant, 0, 0}});
    draw_out();
  }

  RebuiltBone rebuilt() const { return rebuild(bone_, tray(), run_.recording()); }
  Fixation fixation(const RebuiltBone& rebuilt, const std::vector<Body>& bodies) const {
    return fixation_of(run_.recording(), rebuilt, bodies, bone_, {});
  }

  simulator::Bone bone_ = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 8.0}));
  tests::SimulationRun run_{bone_, blade_down({cut_x_mm, 12.0, 0.0}), tray()};
};

TEST_F(SawnBar, HasABodyForEachPartWhetherItMovedOrNot) {
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, {}, "bar");
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
  scenarios::Plan plan;
  plan.fixation.fragments.push_back({.name = "end",
                                     .bone = 0,
                                     .holds_in_bone_mm = {10.0, 0.0, 0.0},
                                     .volume_mm3 = 9.75 * 64.0,
                                     .bone_from_rest = {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 4.0}}});
  lead({0.0, 0.0, 3.0});
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, plan, "bar");
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
  const auto bodies = bodies_of(rebuilt(), plan, "bar");
  EXPECT_EQ(bodies[0].name, "bar");
  EXPECT_EQ(bodies[1].name, "body-2");
}

TEST_F(SawnBar, TellsHowFarAHalfWasLedAndWhatTouches) {
  lead({0.0, 0.0, 4.0}, true);
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, {}, "bar");
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
  bore(wire, 1.0, 1.0, -8.0);
  leave();
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, {}, "bar");
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
  bore(wire, 1.0, 1.0, -8.0);
  leave();
  run_.step({{CommandKind::TakeImplant, 0, 0}});
  run_.glide(pointing({180.0, 1.0, 1.0}, {-1.0, 0.0, 0.0}), 1500);
  run_.hold(10);
  run_.step({{CommandKind::ChooseTool, wire, 0}});
  run_.hold(3);
  bore(wire, -1.0, -1.0, -8.0);
  leave();
  const RebuiltBone bone = rebuilt();
  const Fixation left = fixation(bone, bodies_of(bone, {}, "bar"));
  ASSERT_EQ(left.implants.size(), 1U);
  EXPECT_EQ(left.implants[0].insertions, 2);
}

TEST_F(SawnBar, AScrewAcrossBothHoldsThem) {
  lead({0.0, 0.0, 0.0});
  bore(drill, 0.0, 0.0, -10.0);
  draw_out();
  bore(screw, 0.0, 0.0, -8.5);
  leave();
  const RebuiltBone bone = rebuilt();
  const auto bodies = bodies_of(bone, {}, "bar");
  const Fixation left = fixation(bone, bodies);
  ASSERT_EQ(left.implants.size(), 1U);
  EXPECT_TRUE(left.implants[0].is_screw);
  EXPECT_EQ(left.implants[0].diameter_mm, 2.7);
  EXPECT_EQ(left.implants[0].engages.size(), 2U);
  EXPECT_EQ(held_by(left, bodies), (std::vector<bool>{true, true}));
}

}  // namespace
}  // namespace hallux::assessment
