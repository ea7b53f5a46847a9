/// Screws: by the thread along a pilot hole, as a drill into bone, until the head is seated.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

constexpr double top_mm = 10.0;
const Vec3 down{0.0, -1.0, 0.0};

/// A block of hard bone with a pilot hole of 2 mm, so deep from its top at y = 10.
BoreWorld piloted(double pilot_mm, const Screwdriver& driver) {
  BoreWorld world(cortical_bone(solid_block({40.0, 20.0, 30.0})), bore_tool(driver));
  if (pilot_mm > 0.0) {
    Bore pilot = begin_bore(pointing({0.0, top_mm, 0.0}, down), 0.0, 1.0);
    pilot.depth_mm = pilot_mm;
    world.bores.push_back(pilot);
    world.holes.push_back(capsule_of(pilot));
  }
  world.state.wound_from_tool = pointing({0.0, top_mm + 2.0, 0.0}, down);
  world.glide(pointing({0.0, top_mm - 0.05, 0.0}, down), false, 40);
  return world;
}

/// 2.7 mm thick, a millimetre a turn, two turns a second.
Screwdriver driver_of(double length_mm, bool is_self_drilling = false) {
  return {.screw = {.length_mm = length_mm, .is_self_drilling = is_self_drilling}};
}

TEST(Screw, GoesByItsThreadUntilItsHeadIsSeated) {
  BoreWorld world = piloted(15.0, driver_of(12.0));
  ASSERT_EQ(world.state.stage, BoreStage::InBore);
  int ticks = 0;
  BoreOutcome outcome;
  while (!outcome.head_seated && ticks < 8000) {
    outcome = world.push(6.0, true);
    ++ticks;
  }
  EXPECT_NEAR(world.tip_mm().y, top_mm - 12.0, 0.01);
  EXPECT_NEAR(ticks, 6000, 60);
  EXPECT_FALSE(outcome.chuck_stopped);
}

TEST(Screw, GoesNoFasterWhereItIsPushedHarder) {
  for (const double push_newton : {2.5, 6.0, 25.0}) {
    BoreWorld world = piloted(15.0, driver_of(12.0));
    for (int i = 0; i < 100; ++i) world.push(push_newton, true);
    const double before_mm = world.tip_mm().y;
    for (int i = 0; i < 1000; ++i) world.push(push_newton, true);
    EXPECT_NEAR(before_mm - world.tip_mm().y, 2.0, 1e-6) << push_newton;
  }
}

TEST(Screw, StaysWhereNobodyTurnsOrPushesIt) {
  BoreWorld world = piloted(15.0, driver_of(12.0));
  for (int i = 0; i < 1000; ++i) world.push(6.0, true);
  const double tip_mm = world.tip_mm().y;
  for (int i = 0; i < 500; ++i) world.push(20.0, false);
  for (int i = 0; i < 500; ++i) EXPECT_FALSE(world.push(1.5, true).spins);
  EXPECT_NEAR(world.tip_mm().y, tip_mm, 1e-9);
}

TEST(Screw, SeatedSpinsWithoutGoingOn) {
  BoreWorld world = piloted(15.0, driver_of(8.0));
  for (int i = 0; i < 5000; ++i) world.push(6.0, true);
  const double tip_mm = world.tip_mm().y;
  for (int i = 0; i < 500; ++i) {
    const BoreOutcome outcome = world.push(20.0, true);
    EXPECT_TRUE(outcome.spins);
    EXPECT_TRUE(outcome.head_seated);
    EXPECT_EQ(outcome.advance_mm, 0.0);
  }
  EXPECT_EQ(world.tip_mm().y, tip_mm);
}

TEST(Screw, IsNotDrawnOutOfItsThread) {
  BoreWorld world = piloted(15.0, driver_of(12.0));
  for (int i = 0; i < 1000; ++i) world.push(6.0, true);
  const double tip_mm = world.tip_mm().y;
  const BoreOutcome outcome = world.hold(pointing({0.0, top_mm + 5.0, 0.0}, down), false, 100);
  EXPECT_EQ(world.tip_mm().y, tip_mm);
  EXPECT_NEAR(outcome.force_in_wound_newton.y, -coupling_newton_per_mm * (top_mm + 5.0 - tip_mm),
              1e-6);
}

TEST(Screw, EndsAtThePilotsEndWhereItDoesNotDrill) {
  BoreWorld world = piloted(6.0, driver_of(12.0));
  BoreOutcome outcome;
  for (int i = 0; i < 6000; ++i) outcome = world.push(10.0, true);
  EXPECT_NEAR(world.tip_mm().y, top_mm - 6.0, 0.01);
  EXPECT_TRUE(outcome.spins);
  EXPECT_FALSE(outcome.head_seated);
}

TEST(Screw, ThatDrillsGoesBeyondThePilotByTheSlowerOfThreadAndLaw) {
  // At 6 N the law gives 0.35 (6 - 1.5) / 1.9 = 0.829 mm/s, the thread 2 mm/s.
  BoreWorld world = piloted(6.0, driver_of(12.0, true));
  while (world.tip_mm().y > top_mm - 6.5) world.push(6.0, true);
  const double before_mm = world.tip_mm().y;
  for (int i = 0; i < 1000; ++i) world.push(6.0, true);
  EXPECT_NEAR(before_mm - world.tip_mm().y, 0.35 * 4.5 / 1.9, 0.005);
  // At 25 N it would be 4.3 mm/s.
  const double middle_mm = world.tip_mm().y;
  for (int i = 0; i < 1000; ++i) world.push(25.0, true);
  EXPECT_NEAR(middle_mm - world.tip_mm().y, 2.0, 1e-6);
}

TEST(Screw, WithoutAHoleGoesInOnlyWhereItDrills) {
  BoreWorld plain = piloted(0.0, driver_of(12.0));
  BoreWorld drilling = piloted(0.0, driver_of(12.0, true));
  for (int i = 0; i < 3000; ++i) {
    plain.push(15.0, true);
    drilling.push(15.0, true);
  }
  EXPECT_EQ(plain.bores.size(), 0U);
  EXPECT_NEAR(plain.tip_mm().y, top_mm, 0.01);
  ASSERT_EQ(drilling.bores.size(), 1U);
  EXPECT_NEAR(drilling.bores[0].radius_mm, 0.95, 1e-12);
  EXPECT_GT(drilling.bores[0].depth_mm, 3.0);
}

TEST(Screw, OverItsGuideWireBoresAWiderHoleAlongTheSameAxis) {
  BoreWorld world = piloted(0.0, driver_of(12.0, true));
  Bore guide = begin_bore(pointing({0.0, top_mm, 0.0}, down), 0.0, 0.55);
  guide.depth_mm = 15.0;
  world.bores.push_back(guide);
  world.holes.push_back(capsule_of(guide));
  int ticks = 0;
  while (!world.push(10.0, true).head_seated && ticks < 20000) ++ticks;
  ASSERT_EQ(world.bores.size(), 2U);
  EXPECT_EQ(world.bores[1].body_from_bore, guide.body_from_bore);
  EXPECT_NEAR(world.tip_mm().y, top_mm - 12.0, 0.01);
  // The middle of its disc is air: 8 of 9 points stand in bone.
  const double rate_mm_s = 0.35 * (10.0 - 1.5) / (1.9 * 8.0 / 9.0);
  EXPECT_NEAR(ticks, 12.0 / (0.001 * rate_mm_s), 100.0);
}

TEST(Screw, AslantIsSeatedWhereItsHeadFirstMeetsBone) {
  const double slant = 0.5;  // 30 degrees
  const Vec3 ahead{slant, -std::sqrt(1.0 - slant * slant), 0.0};
  BoreWorld world(cortical_bone(solid_block({40.0, 20.0, 30.0})), bore_tool(driver_of(8.0)));
  Bore pilot = begin_bore(pointing({-5.0, top_mm, 0.0}, ahead), 0.0, 1.0);
  pilot.depth_mm = 15.0;
  world.bores.push_back(pilot);
  world.holes.push_back(capsule_of(pilot));
  world.state.wound_from_tool = pointing(Vec3{-5.0, top_mm, 0.0} - 2.0 * ahead, ahead);
  world.glide(pointing(Vec3{-5.0, top_mm, 0.0} + 0.1 * ahead, ahead), false, 40);
  int ticks = 0;
  while (!world.push(6.0, true).head_seated && ticks < 8000) ++ticks;
  // The head's rim is 2.5 sin 30 below its middle: seen along the axis 2.5 tan 30 sooner. Its
  // points are 45 degrees apart, so the lowest is met by cos 22.5 at least.
  const double way_mm = glm::dot(world.tip_mm() - Vec3{-5.0, top_mm, 0.0}, ahead);
  const double sooner_mm = 2.5 * std::tan(0.5235987755982988);
  EXPECT_GE(way_mm, 8.0 - sooner_mm - 0.01);
  EXPECT_LE(way_mm, 8.0 - 0.92 * sooner_mm + 0.01);
}

}  // namespace
}  // namespace hallux::tests
