#include "assessment/process/saw_care.h"

#include <gtest/gtest.h>

#include "tests/assessment/process/made_recording.h"
#include "tests/support/worlds.h"

namespace hallux::assessment {
namespace {

using simulator::Recording;
using testing::add_line;
using testing::add_lines;
using testing::MadeLine;

constexpr double exact = 1e-6;
/// Of the block in the world: 100 mm away, half turned about z.
const RigidTransform world_from_block{Quat(0.0, 0.0, 0.0, 1.0), Vec3{100.0, 0.0, 0.0}};
constexpr double half_mm = 10.0;

/// So far from the block, seen from the origin of the world.
MadeLine in_air(double away_mm, std::uint32_t status = testing::saw_on) {
  return {.status = status, .tip_mm = {100.0 - half_mm - away_mm, 0.0, 0.0}};
}

SawCare care_of(const Recording& recording) {
  const simulator::Bvh surface(tests::solid_block({2.0 * half_mm, 2.0 * half_mm, 2.0 * half_mm}));
  return measure_saw_care(recording, surface, inverse(world_from_block));
}

TEST(SawCare, TwoSecondsInTheAirAreNone) {
  Recording recording;
  add_line(recording, {});
  add_lines(recording, in_air(10.0), 2000);
  EXPECT_EQ(care_of(recording).air_s.value, 0.0);
  add_line(recording, in_air(10.0));
  const Finding air = care_of(recording).air_s;
  EXPECT_NEAR(air.value, 2.001, exact);
  EXPECT_EQ(air.first_tick, 1);
  EXPECT_EQ(air.last_tick, 2001);
}

TEST(SawCare, StretchesInTheAirAddUpAndTheLongestIsShown) {
  Recording recording;
  add_lines(recording, in_air(1.0), 2500);
  add_lines(recording, in_air(0.0, testing::saw_on | testing::contact), 10);
  add_lines(recording, in_air(1.0), 3000);
  add_lines(recording, in_air(1.0, 0U), 10);
  add_lines(recording, in_air(1.0), 1900);
  const Finding air = care_of(recording).air_s;
  EXPECT_NEAR(air.value, 5.5, exact);
  EXPECT_EQ(air.first_tick, 2510);
  EXPECT_EQ(air.last_tick, 5509);
}

TEST(SawCare, FurtherThanFiftyMillimetresIsNotAtWork) {
  for (const auto& [away_mm, air_s] : {std::pair{49.9, 3.0}, std::pair{50.1, 0.0}}) {
    Recording recording;
    add_lines(recording, in_air(away_mm), 3000);
    EXPECT_NEAR(care_of(recording).air_s.value, air_s, exact) << away_mm;
  }
  // There and back, step by step: 1 mm a tick.
  Recording recording;
  for (int away_mm = 10; away_mm < 90; ++away_mm) add_line(recording, in_air(away_mm));
  add_lines(recording, in_air(90.0), 2500);
  for (int away_mm = 90; away_mm > 10; --away_mm) add_line(recording, in_air(away_mm));
  EXPECT_EQ(care_of(recording).air_s.value, 0.0);
  add_lines(recording, in_air(10.0), 2001 - 39);
  EXPECT_NEAR(care_of(recording).air_s.value, 2.001, exact);
}

TEST(SawCare, AGapEndsAStretchAndMissedTicksOfALineDoNot) {
  Recording recording;
  add_line(recording, {});
  for (int line = 0; line < 667; ++line) add_line(recording, in_air(5.0), 3);
  EXPECT_NEAR(care_of(recording).air_s.value, 2.001, exact);
  recording = {};
  add_lines(recording, in_air(5.0), 1500);
  MadeLine later = in_air(5.0);
  later.missed = 3;
  add_line(recording, later);
  add_lines(recording, in_air(5.0), 1500);
  EXPECT_EQ(care_of(recording).air_s.value, 0.0);
}

TEST(SawCare, SwitchingOnWhileTeethTouchBoneIsToldOnce) {
  Recording recording;
  add_lines(recording, in_air(0.0, testing::contact), 5);
  EXPECT_EQ(care_of(recording).started_in_bone.value, 0.0);
  add_lines(recording, in_air(0.0, testing::contact | testing::saw_on), 5);
  add_lines(recording, in_air(0.0, testing::contact), 5);
  add_lines(recording, in_air(0.0, testing::contact | testing::saw_on), 5);
  const Finding started = care_of(recording).started_in_bone;
  EXPECT_EQ(started.value, 1.0);
  EXPECT_EQ(started.first_tick, 5);
  EXPECT_EQ(started.last_tick, 5);
}

TEST(SawCare, ASawThatRanBeforeItTouchedWasNotStartedInBone) {
  Recording recording;
  add_line(recording, in_air(1.0, 0U));
  add_line(recording, in_air(1.0));
  add_lines(recording, in_air(0.0, testing::contact | testing::saw_on), 5);
  add_lines(recording, in_air(0.0, testing::contact), 5);
  EXPECT_EQ(care_of(recording).started_in_bone.value, 0.0);
}

TEST(SawCare, TheWetShareIsOfTheTicksThatCut) {
  Recording recording;
  add_line(recording, in_air(1.0));
  add_lines(recording, in_air(0.0, testing::cutting | testing::irrigated), 4);
  add_line(recording, in_air(0.0, testing::cutting), 3);
  add_line(recording, in_air(0.0, testing::cutting | testing::irrigated), 2);
  add_lines(recording, in_air(0.0, testing::contact), 50);
  MadeLine later = in_air(0.0, testing::cutting);
  later.missed = 40;
  add_line(recording, later);
  // Wet 4 + 2 of 4 + 3 + 2 + 1.
  const Finding share = care_of(recording).irrigated_share.value();
  EXPECT_NEAR(share.value, 0.6, exact);
  EXPECT_EQ(share.first_tick, 7);
}

TEST(SawCare, WithoutSawingThereIsNoWetShare) {
  Recording recording;
  add_lines(recording, in_air(1.0, testing::saw_on | testing::irrigated), 5);
  EXPECT_FALSE(care_of(recording).irrigated_share);
}

}  // namespace
}  // namespace hallux::assessment
