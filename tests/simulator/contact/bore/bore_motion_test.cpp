/// Wire and drill: what a hand feels at a slab and a tube, and where the tip goes.
#include "simulator/contact/bore/bore_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "simulator/cutting/hole/skin_crossings.h"
#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

constexpr double top_mm = 10.0;
const Vec3 down{0.0, -1.0, 0.0};

/// 1.6 mm thick, at the rated speed.
BoreTool wire() { return bore_tool(WireDriver{}); }

/// The law's rate of that wire in cortical bone at 10 N.
constexpr double law_mm_s = 0.35 * (10.0 - 1.5) / 1.6;

/// A slab whose top lies at y = 10.
Bone slab(double thickness_mm) {
  return cortical_bone(moved(solid_block({40.0, thickness_mm, 30.0}),
                             {{1.0, 0.0, 0.0, 0.0}, {0.0, top_mm - 0.5 * thickness_mm, 0.0}}));
}

/// A tool that stands on the slab at a place, at rest.
void set_down(BoreWorld& world, const Vec3& place_mm, const Vec3& ahead = down) {
  world.state.wound_from_tool = pointing(place_mm - 2.0 * ahead, ahead);
  world.glide(pointing(place_mm + 0.5 * ahead, ahead), false, 20);
}

/// Ticks under a push until something happens.
template <typename Until>
int push_until(BoreWorld& world, double force_newton, int limit, const Until& until) {
  for (int ticks = 1; ticks <= limit; ++ticks) {
    if (until(world.push(force_newton, true))) return ticks;
  }
  return limit + 1;
}

TEST(FreePoint, FollowsTheHandWithoutAForce) {
  BoreWorld world(slab(5.0), wire());
  const RigidTransform pose = pointing({3.0, top_mm + 1.4, 0.5}, down);
  world.state.wound_from_tool = pointing({3.0, top_mm + 2.0, 0.5}, down);
  const BoreOutcome outcome = world.hold(pose, true, 5);
  EXPECT_EQ(world.state.wound_from_tool, pose);
  EXPECT_EQ(outcome.force_in_wound_newton, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(world.state.stage, BoreStage::Free);
}

TEST(FreePoint, NoHandIsFastEnoughToCarryItThroughBone) {
  BoreWorld world(slab(2.0), wire());
  world.state.wound_from_tool = pointing({0.0, top_mm + 3.0, 0.0}, down);
  const BoreOutcome outcome = world.hold(pointing({0.0, top_mm - 40.0, 0.0}, down), false, 100);
  EXPECT_EQ(world.state.stage, BoreStage::OnBone);
  EXPECT_NEAR(world.tip_mm().y, top_mm, 0.01);
  EXPECT_TRUE(outcome.is_force_limited);
  EXPECT_NEAR(outcome.force_in_wound_newton.y, 30.0, 1e-9);
}

TEST(FreePoint, BoneHoldsTheShaft) {
  BoreWorld world(slab(5.0), wire());
  const Vec3 along{1.0, 0.0, 0.0};
  world.state.wound_from_tool = pointing({10.0, top_mm + 3.0, 0.0}, along);
  const BoreOutcome outcome = world.glide(pointing({10.0, top_mm - 2.0, 0.0}, along), true, 200);
  EXPECT_EQ(world.bores.size(), 0U);
  EXPECT_GT(outcome.force_in_wound_newton.y, 2.0);
  EXPECT_GT(world.tip_mm().y, top_mm);
}

TEST(PointOnBone, PushesBackWithTheSpring) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  const BoreOutcome outcome = world.hold(pointing({0.0, top_mm - 3.0, 0.0}, down), false, 50);
  EXPECT_NEAR(outcome.force_in_wound_newton.y, coupling_newton_per_mm * 3.0, 0.01);
}

TEST(PointOnBone, AtRestBoresNothing) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  for (int i = 0; i < 2000; ++i) EXPECT_FALSE(world.push(20.0, false).wants_bore);
  EXPECT_NEAR(world.tip_mm().y, top_mm, 0.01);
  EXPECT_EQ(world.bores.size(), 0U);
}

TEST(PointOnBone, RunningAdvancesByTheFeedLawAndAsksForABoreAtThreeTenths) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  const int ticks =
      push_until(world, 10.0, 1000, [](const BoreOutcome& outcome) { return outcome.wants_bore; });
  EXPECT_NEAR(ticks, 0.3 / (0.001 * law_mm_s), 5.0);
  ASSERT_EQ(world.bores.size(), 1U);
  EXPECT_NEAR(world.bores[0].body_from_bore.translation_mm.y, top_mm, 0.01);
}

TEST(PointOnBone, AShallowTouchEndsAsAScratchOfItsDepth) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  for (int i = 0; i < 50; ++i) world.push(10.0, true);
  const double depth_mm = world.state.scratch_mm;
  EXPECT_NEAR(depth_mm, 0.05 * law_mm_s, 0.01);
  double scratch_mm = 0.0;
  for (int i = 0; i < 100 && world.state.stage == BoreStage::OnBone; ++i)
    scratch_mm = world.tick(pointing({0.0, top_mm + 1.0, 0.0}, down), true).scratch_mm;
  EXPECT_EQ(scratch_mm, depth_mm);
  EXPECT_EQ(world.bores.size(), 0U);
}

Vec3 at_angle(double degrees) {
  const double angle_rad = radian_from_degree(degrees);
  return {elementary::cos(angle_rad), -elementary::sin(angle_rad), 0.0};
}

TEST(PointOnBone, SkidsBelowThirtyDegrees) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {-10.0, top_mm, 0.0}, at_angle(25.0));
  const double begin_mm = world.tip_mm().x;
  BoreOutcome outcome;
  // A hand that keeps its push runs away with it: at most 1.5 mm a tick.
  for (int i = 0; i < 10; ++i) {
    outcome = world.push(6.0, true);
    EXPECT_TRUE(outcome.skids);
  }
  EXPECT_EQ(world.bores.size(), 0U);
  EXPECT_GT(world.tip_mm().x, begin_mm + 1.5);
  EXPECT_NEAR(world.tip_mm().y, top_mm, 0.06);
}

TEST(PointOnBone, BoresAtThirtyFiveDegreesWhereItStands) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {-10.0, top_mm, 0.0}, at_angle(35.0));
  const double begin_mm = world.tip_mm().x;
  const int ticks =
      push_until(world, 10.0, 2000, [](const BoreOutcome& outcome) { return outcome.wants_bore; });
  EXPECT_NEAR(ticks, 0.3 / (0.001 * law_mm_s), 8.0);
  EXPECT_NEAR(world.tip_mm().x, begin_mm + 0.3 * at_angle(35.0).x, 0.02);
}

TEST(PointOnBone, AtRestDoesNotSkidButHoldsByFriction) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {-10.0, top_mm, 0.0}, at_angle(80.0));
  const double begin_mm = world.tip_mm().x;
  for (int i = 0; i < 300; ++i) EXPECT_FALSE(world.push(6.0, false).skids);
  EXPECT_NEAR(world.tip_mm().x, begin_mm, 0.01);  // tan 10 degrees is below 0.3
}

TEST(Bore, GoesThroughASlabInTheTimeOfTheLaw) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  BoreOutcome last;
  const int ticks = push_until(world, 10.0, 4000, [&](const BoreOutcome& outcome) {
    last = outcome;
    return outcome.broke_through;
  });
  // Asked for bone 0.02 mm ahead, the tip is free that much before the far face.
  EXPECT_NEAR(ticks, (5.0 - 0.02) / (0.001 * law_mm_s), 6.0);
  EXPECT_NEAR(world.tip_mm().y, top_mm - 5.0, 0.21);  // a tick of giving way
  EXPECT_NEAR(last.broke_at_newton, 10.0, 0.02);
}

TEST(Bore, IsFedAsTheMixOfItsDiscSays) {
  // The slab ends at x = 20: half of the disc hangs in the air.
  BoreWorld world(slab(20.0), wire());
  set_down(world, {19.9, top_mm, 0.0});
  push_until(world, 10.0, 1000, [](const BoreOutcome& outcome) { return outcome.wants_bore; });
  const BoreOutcome outcome = world.push(10.0, true);
  const double width_mm = outcome.engaged.cortical_mm;
  EXPECT_NEAR(width_mm, 1.6 * 6.0 / 9.0, 1e-12);  // six of the nine points lie within
  EXPECT_NEAR(outcome.advance_mm, 0.001 * 0.35 * (10.0 - 1.5) / width_mm, 1e-9);
}

TEST(Bore, ThreeTicksInOneLineAdvanceThreeTimesAsFar) {
  BoreWorld one(slab(5.0), wire()), three(slab(5.0), wire());
  for (BoreWorld* world : {&one, &three}) {
    set_down(*world, {0.0, top_mm, 0.0});
    for (int i = 0; i < 400; ++i) world->push(10.0, true);
  }
  RigidTransform handle = one.state.wound_from_tool;
  handle.translation_mm += 5.0 * down;
  const double single_mm = one.tick(handle, true).advance_mm;
  EXPECT_NEAR(three.tick(handle, true, 0.003).advance_mm, 3.0 * single_mm, 1e-12);
}

TEST(Bore, StandsStillBelowTheThresholdAndWithARestingDrive) {
  BoreWorld world(slab(5.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  for (int i = 0; i < 500; ++i) world.push(10.0, true);
  const double tip_mm = world.tip_mm().y;
  for (int i = 0; i < 200; ++i) world.push(1.4, true);
  for (int i = 0; i < 200; ++i) world.push(20.0, false);
  EXPECT_NEAR(world.tip_mm().y, tip_mm, 1e-9);
}

TEST(Bore, LetsThePointGoAtTwoTenthsOfAMillimetreATick) {
  BoreWorld world(slab(2.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  for (int i = 0; i < 300; ++i) world.push(10.0, true);
  // From here on the hand stays, 5 mm beyond the far face.
  const RigidTransform handle = pointing({0.0, top_mm - 7.0, 0.0}, down);
  world.glide(handle, true, 50);
  int ticks = 0;
  while (!world.tick(handle, true).broke_through && ticks < 4000) ++ticks;
  const double stretch_mm = world.tip_mm().y - (top_mm - 7.0);
  ASSERT_GT(stretch_mm, 4.5);
  double last_mm = world.tip_mm().y;
  BoreOutcome outcome;
  for (ticks = 0; last_mm > top_mm - 7.0 + 1e-9 && ticks < 200; ++ticks) {
    outcome = world.tick(handle, true);
    EXPECT_LE(last_mm - world.tip_mm().y, 0.2 + 1e-9);
    EXPECT_FALSE(outcome.broke_through);
    last_mm = world.tip_mm().y;
  }
  EXPECT_NEAR(ticks, stretch_mm / 0.2, 1.5);
  EXPECT_NEAR(outcome.force_in_wound_newton.y, 0.0, 1e-6);
}

/// A tube around x with walls of 3 mm and marrow within.
Bone tube() {
  Bone bone = cortical_bone(hollow_tube({.inner_radius_mm = 0.0, .segments = 256}));
  bone.canal = inside_out(hollow_tube(
      {.outer_radius_mm = 5.0, .inner_radius_mm = 0.0, .length_mm = 52.0, .segments = 256}));
  bone.cortex = CortexLaw{.mid_mm = 3.0, .floor_mm = 3.0};
  return bone;
}

TEST(Bore, OfATubeMeetsTwoCorticesAndBreaksThroughOnce) {
  const Bone bone = tube();
  BoreWorld world(bone, bore_tool(WireDriver{.wire = {.diameter_mm = 0.9}}));
  set_down(world, {0.0, 8.0, 0.0});
  int in_bone = 0, fronts = 0, breaks = 0;
  bool was_in_bone = false;
  double broke_mm = 0.0;
  for (int i = 0; i < 8000 && breaks == 0; ++i) {
    const BoreOutcome outcome = world.push(10.0, true);
    const bool is_in_bone = outcome.engaged.width_mm() > 0.0;
    in_bone += is_in_bone ? 1 : 0;
    fronts += is_in_bone && !was_in_bone ? 1 : 0;
    was_in_bone = is_in_bone;
    breaks += outcome.broke_through ? 1 : 0;
    broke_mm = world.tip_mm().y;
  }
  EXPECT_EQ(breaks, 1);
  EXPECT_EQ(fronts, 2);
  EXPECT_NEAR(broke_mm, -8.0, 0.21);
  // The walls curve away by 0.3^2 / 2 R = 6 um under the ring of the disc: below 0.05 mm a side.
  const double rate_mm_s = 0.35 * (10.0 - 1.5) / 0.9;
  EXPECT_NEAR(in_bone, 6.0 / (0.001 * rate_mm_s), 0.2 / (0.001 * rate_mm_s));
  const Capsule hole = world.holes[0];
  const Vec3 way = unit(hole.to_in_body_mm - hole.from_in_body_mm);
  EXPECT_EQ(skin_crossings(Bvh(bone.outer), hole.from_in_body_mm, world.tip_mm() + way).size(), 2U);
}

TEST(Bore, DoesNotBreakThroughIntoTheCanal) {
  BoreWorld world(tube(), wire());
  set_down(world, {0.0, 8.0, 0.0});
  for (int i = 0; i < 3000 && world.tip_mm().y > 0.0; ++i)
    EXPECT_FALSE(world.push(10.0, true).broke_through);
  EXPECT_LE(world.tip_mm().y, 0.0);
}

TEST(Bore, CrossesAnOpenKerfIntoTheNextFragmentWithoutABreakThrough) {
  BoreWorld world(slab(10.0), wire());
  // A kerf of half a millimetre in the plane y = 5.
  world.saw({rotation_from_axes(Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, -1.0}), {-25.0, 5.0, 0.0}},
            35.0);
  ASSERT_EQ(world.standing().at({0.0, 5.0, 0.0}), Tissue::None);
  ASSERT_EQ(world.standing().at({0.0, 5.3, 0.0}), Tissue::Cortical);
  set_down(world, {0.0, top_mm, 0.0});
  int in_air = 0, breaks = 0;
  for (int i = 0; i < 8000 && world.tip_mm().y > 0.5; ++i) {
    const BoreOutcome outcome = world.push(10.0, true);
    breaks += outcome.broke_through ? 1 : 0;
    in_air += outcome.engaged.width_mm() > 0.0 ? 0 : 1;
  }
  EXPECT_LE(world.tip_mm().y, 0.5);
  EXPECT_EQ(breaks, 0);
  EXPECT_GE(in_air, 1);
  EXPECT_EQ(world.bores.size(), 1U);
  for (int i = 0; i < 1000 && breaks == 0; ++i)
    breaks += world.push(10.0, true).broke_through ? 1 : 0;
  EXPECT_EQ(breaks, 1);
  EXPECT_NEAR(world.tip_mm().y, 0.0, 0.21);
}

TEST(Bore, HoldsTheToolToItsAxisWithTheSpring) {
  BoreWorld world(slab(20.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  for (int i = 0; i < 2000; ++i) world.push(10.0, true);
  const Vec3 tip = world.tip_mm();
  const BoreOutcome outcome = world.hold(pointing(tip + Vec3{1.5, 0.0, 0.0}, down), true, 50);
  EXPECT_NEAR(world.tip_mm().x, tip.x, 1e-9);
  EXPECT_NEAR(outcome.force_in_wound_newton.x, -3.0, 1e-6);
  EXPECT_NEAR(outcome.force_in_wound_newton.y, 0.0, 1e-6);
}

TEST(Bore, LetsTheToolSpinAboutItsAxisAndNotTilt) {
  BoreWorld world(slab(20.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  for (int i = 0; i < 2000; ++i) world.push(10.0, true);
  const RigidTransform here = world.state.wound_from_tool;
  const RigidTransform turned{rotation_about(down, 0.8) * here.rotation, here.translation_mm};
  const Vec3 spun = world.hold(turned, true, 400).torque_in_wound_newton_mm;
  EXPECT_NEAR(length_of(spun), 0.0, 1e-6);
  EXPECT_NEAR(length_of(axis_y(world.state.wound_from_tool) - axis_y(turned)), 0.0, 1e-6);
  const RigidTransform tilted{rotation_about(Vec3{0.0, 0.0, 1.0}, 0.05) * here.rotation,
                              here.translation_mm};
  const Vec3 held = world.hold(tilted, true, 400).torque_in_wound_newton_mm;
  EXPECT_NEAR(length_of(held), 4000.0 * 0.05, 1.0);
  EXPECT_NEAR(length_of(axis_x(world.state.wound_from_tool) - down), 0.0, 1e-9);
}

TEST(Bore, IsLeftBackwardsFreelyAndFoundAgain) {
  BoreWorld world(slab(20.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  for (int i = 0; i < 3000; ++i) world.push(10.0, true);
  const double depth_mm = world.bores[0].depth_mm;
  ASSERT_GT(depth_mm, 5.0);
  const BoreOutcome drawn = world.glide(pointing({0.0, top_mm + 3.0, 0.0}, down), false, 400);
  EXPECT_EQ(world.state.stage, BoreStage::Free);
  EXPECT_NEAR(length_of(drawn.force_in_wound_newton), 0.0, 1e-6);
  EXPECT_EQ(world.bores[0].depth_mm, depth_mm);
  // 0.3 mm beside and three degrees aslant, with a resting drive.
  const Vec3 aslant{elementary::sin(0.05), -elementary::cos(0.05), 0.0};
  world.glide(pointing({0.3, top_mm + 1.0, 0.0}, aslant), false, 200);
  world.glide(pointing({0.3, top_mm - depth_mm - 2.0, 0.0}, down), false, 400);
  const BoreOutcome outcome =
      world.hold(pointing({0.0, top_mm - depth_mm - 2.0, 0.0}, down), false, 50);
  EXPECT_EQ(world.state.stage, BoreStage::InBore);
  EXPECT_EQ(world.bores.size(), 1U);
  EXPECT_NEAR(world.tip_mm().y, top_mm - depth_mm, 0.01);
  EXPECT_NEAR(world.tip_mm().x, 0.0, 1e-9);
  EXPECT_NEAR(outcome.force_in_wound_newton.y, 4.0, 0.05);
}

TEST(Bore, AMillimetreBesideIsAnotherOne) {
  BoreWorld world(slab(20.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  for (int i = 0; i < 1000; ++i) world.push(10.0, true);
  world.glide(pointing({0.0, top_mm + 3.0, 0.0}, down), false, 400);
  world.glide(pointing({2.0, top_mm + 0.5, 0.0}, down), false, 100);
  world.glide(pointing({2.0, top_mm - 0.5, 0.0}, down), false, 50);
  for (int i = 0; i < 1000; ++i) world.push(10.0, true);
  EXPECT_EQ(world.bores.size(), 2U);
  EXPECT_EQ(world.state.bore, 1);
}

TEST(Bore, ThatCrossesAnOldHoleFallsIntoIt) {
  BoreWorld world(slab(20.0), bore_tool(Drill{}));
  // An old hole of 3 mm across the way, 4 mm deep.
  world.holes.push_back({{-30.0, 6.0, 0.0}, {30.0, 6.0, 0.0}, 1.5});
  world.bores.push_back(begin_bore(pointing({-30.0, 6.0, 0.0}, {1.0, 0.0, 0.0}), 0.0, 1.5));
  world.bores[0].depth_mm = 61.5;
  set_down(world, {0.0, top_mm, 0.0});
  bool fell = false;
  for (int i = 0; i < 4000 && !fell; ++i) {
    const BoreOutcome outcome = world.push(10.0, true);
    EXPECT_FALSE(outcome.broke_through);
    fell = world.state.stage == BoreStage::InBore && !(outcome.engaged.width_mm() > 0.0);
  }
  EXPECT_TRUE(fell);
  // The old hole begins at 7.5; its wall is met by the ring of the disc 0.19 mm later.
  EXPECT_NEAR(world.tip_mm().y, 7.3, 0.25);
}

TEST(Bore, TakesADrillIntoItsMouthWithoutARunningDrive) {
  BoreWorld world(slab(20.0), wire());
  // Wider than the wire, and none that it could be led by: it only falls in.
  world.holes.push_back({{0.0, 12.0, 0.0}, {0.0, 2.0, 0.0}, 1.5});
  world.state.wound_from_tool = pointing({0.2, top_mm + 2.0, 0.0}, down);
  world.glide(pointing({0.2, top_mm - 5.0, 0.0}, down), false, 200);
  EXPECT_NEAR(world.tip_mm().y, top_mm - 5.0, 0.05);
  // Its wall holds the shaft: 1.5 - 0.8 mm aside at most.
  const BoreOutcome outcome = world.glide(pointing({1.5, top_mm - 5.0, 0.0}, down), false, 200);
  EXPECT_NEAR(world.tip_mm().x, 0.7, 0.1);
  EXPECT_LT(outcome.force_in_wound_newton.x, -1.0);
}

TEST(Bore, IsStoppedByMetal) {
  BoreWorld world(slab(20.0), wire());
  world.metal.push_back({{-30.0, 6.0, 0.0}, {30.0, 6.0, 0.0}, 0.8});
  set_down(world, {0.0, top_mm, 0.0});
  BoreOutcome outcome;
  for (int i = 0; i < 4000; ++i) outcome = world.push(10.0, true);
  EXPECT_EQ(outcome.metal, 0);
  EXPECT_NEAR(world.tip_mm().y, 6.8, 0.03);
}

TEST(Bore, EndsWhereTheChuckStandsOnTheBone) {
  BoreTool drill = bore_tool(Drill{.bit = {.length_mm = 30.0}});
  drill.shaft_mm = 6.0;
  BoreWorld world(slab(20.0), drill);
  set_down(world, {0.0, top_mm, 0.0});
  BoreOutcome outcome;
  for (int i = 0; i < 6000; ++i) outcome = world.push(10.0, true);
  EXPECT_TRUE(outcome.chuck_stopped);
  EXPECT_FALSE(outcome.head_seated);
  EXPECT_NEAR(world.tip_mm().y, top_mm - 6.0, 0.01);
}

TEST(Bore, ARefusedPointStaysWhereItIs) {
  BoreWorld world(slab(20.0), wire());
  set_down(world, {0.0, top_mm, 0.0});
  world.state.is_refused = true;
  for (int i = 0; i < 500; ++i) EXPECT_FALSE(world.push(20.0, true).wants_bore);
  EXPECT_NEAR(world.tip_mm().y, top_mm, 0.01);
}

}  // namespace
}  // namespace hallux::tests
