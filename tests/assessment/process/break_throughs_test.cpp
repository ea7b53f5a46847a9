#include "assessment/process/break_throughs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/assessment/process/made_recording.h"

namespace hallux::assessment {
namespace {

using simulator::Recording;
using testing::add_line;

constexpr double exact = 1e-6;
constexpr simulator::Blade blade{.width_mm = 10.0, .depth_mm = 40.0};
/// Half turned about z: what is fed along the world's x goes along the bone's -x.
const RigidTransform bone_from_world{Quat(0.0, 0.0, 0.0, 1.0), Vec3{7.0, 3.0, 0.0}};

BreakThroughs found_in(const Recording& recording, std::vector<std::int32_t> kerfs = {0}) {
  return measure_break_throughs({recording, blade, bone_from_world}, kerfs);
}

/// Teeth that are fed so far each tick, with this push.
struct Feed {
  double step_mm = 0.0, push_newton = 0.0;
};

/// Goes on from where the teeth stand.
void feed(Recording& recording, double& place_mm, std::int64_t ticks, const Feed& how) {
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    place_mm += how.step_mm;
    add_line(recording,
             {.tip_mm = {place_mm, 0.0, 0.0}, .force_newton = {-how.push_newton, 0.0, 0.0}});
  }
}

void break_through(Recording& recording, std::int32_t kerf = 0) {
  testing::add_event(recording, simulator::CutEventKind::Breakthrough, kerf);
}

TEST(BreakThroughs, WithoutOneThereIsNoPlungeAndNothingElse) {
  Recording recording;
  double place_mm = 0.0;
  feed(recording, place_mm, 100, {0.01, 9.0});
  break_through(recording, 1);
  feed(recording, place_mm, 300, {0.05, 9.0});
  const BreakThroughs found = found_in(recording);
  EXPECT_EQ(found.plunge_mm.value, 0.0);
  EXPECT_FALSE(found.force_newton);
  EXPECT_FALSE(found.speed_mm_s);
}

TEST(BreakThroughs, ThePlungeIsTheWayAlongTheFeedInTwoTenthsOfASecond) {
  Recording recording;
  double place_mm = 2.0;
  feed(recording, place_mm, 100, {0.01, 9.0});
  break_through(recording);
  feed(recording, place_mm, 150, {0.02, 2.0});
  feed(recording, place_mm, 50, {-0.01, 0.0});
  feed(recording, place_mm, 100, {0.1, 0.0});
  const Finding plunge = found_in(recording).plunge_mm;
  EXPECT_NEAR(plunge.value, 150 * 0.02, exact);
  EXPECT_EQ(plunge.first_tick, 99);
  EXPECT_EQ(plunge.last_tick, 99 + 150);
  // The tooth at either end of the line; x of the bone runs against that of the world.
  EXPECT_NEAR(found_in(recording).plunge_in_bone_mm.x, 7.0 - 6.0, exact);
  EXPECT_NEAR(std::abs(found_in(recording).plunge_in_bone_mm.y - 3.0), 5.0, exact);
}

TEST(BreakThroughs, ThePlungeEndsWithTheTwoHundredthTick) {
  Recording recording;
  double place_mm = 0.0;
  feed(recording, place_mm, 1, {});
  break_through(recording);
  feed(recording, place_mm, 400, {0.01, 0.0});
  EXPECT_NEAR(found_in(recording).plunge_mm.value, 2.0, exact);
}

TEST(BreakThroughs, OfABladeThatTurnsTheFurthestToothCounts) {
  Recording recording;
  add_line(recording, {});
  break_through(recording);
  // Twice the angle of (4, 3): its sine is 0.96.
  add_line(recording, {.tip_mm = {0.5, 0.0, 0.0}, .rotation = Quat(0.8, 0.0, 0.0, 0.6)});
  EXPECT_NEAR(found_in(recording).plunge_mm.value, 0.5 + 5.0 * 0.96, exact);
}

TEST(BreakThroughs, AWayAcrossTheFeedIsNoPlunge) {
  Recording recording;
  add_line(recording, {});
  break_through(recording);
  add_line(recording, {.tip_mm = {0.0, 4.0, -3.0}});
  EXPECT_EQ(found_in(recording).plunge_mm.value, 0.0);
}

TEST(BreakThroughs, TheForceIsTheMeanOverTwentyTicksBefore) {
  Recording recording;
  double place_mm = 0.0;
  feed(recording, place_mm, 79, {0.0, 30.0});
  feed(recording, place_mm, 10, {0.0, 4.0});
  feed(recording, place_mm, 10, {0.0, 10.0});
  feed(recording, place_mm, 1, {0.0, 50.0});
  break_through(recording);
  feed(recording, place_mm, 100, {0.0, 50.0});
  const Finding force = found_in(recording).force_newton.value();
  EXPECT_NEAR(force.value, 7.0, exact);
  EXPECT_EQ(force.first_tick, 79);
  EXPECT_EQ(force.last_tick, 99);
}

TEST(BreakThroughs, TheSpeedIsTheMeanOverFiftyTicksAfter) {
  Recording recording;
  double place_mm = 0.0;
  feed(recording, place_mm, 10, {0.2, 0.0});
  break_through(recording);
  feed(recording, place_mm, 25, {0.03, 0.0});
  feed(recording, place_mm, 25, {0.01, 0.0});
  feed(recording, place_mm, 100, {0.5, 0.0});
  const Finding speed = found_in(recording).speed_mm_s.value();
  EXPECT_NEAR(speed.value, 20.0, exact);
  EXPECT_EQ(speed.first_tick, 9);
  EXPECT_EQ(speed.last_tick, 59);
}

TEST(BreakThroughs, ABladeThatIsDrawnBackHasNoSpeed) {
  Recording recording;
  double place_mm = 0.0;
  feed(recording, place_mm, 10, {});
  break_through(recording);
  feed(recording, place_mm, 60, {-0.02, 0.0});
  EXPECT_EQ(found_in(recording).speed_mm_s->value, 0.0);
  EXPECT_EQ(found_in(recording).plunge_mm.value, 0.0);
}

// The first plunges further, the second is pushed harder and leaves faster.
TEST(BreakThroughs, OfSeveralTheWorstCountsOneByOne) {
  Recording recording;
  double place_mm = 0.0;
  feed(recording, place_mm, 30, {0.0, 5.0});
  break_through(recording, 0);
  feed(recording, place_mm, 200, {0.02, 0.0});
  feed(recording, place_mm, 300, {-0.01, 0.0});
  feed(recording, place_mm, 30, {0.0, 8.0});
  break_through(recording, 2);
  feed(recording, place_mm, 50, {0.04, 0.0});
  feed(recording, place_mm, 200, {0.0, 0.0});
  const BreakThroughs both = found_in(recording, {0, 2});
  EXPECT_NEAR(both.plunge_mm.value, 4.0, exact);
  EXPECT_NEAR(both.force_newton->value, 8.0, exact);
  EXPECT_NEAR(both.speed_mm_s->value, 40.0, exact);
  EXPECT_NEAR(found_in(recording, {2}).plunge_mm.value, 2.0, exact);
  EXPECT_NEAR(found_in(recording, {0}).speed_mm_s->value, 20.0, exact);
}

TEST(BreakThroughs, AtTheVeryEndOfARecordingTellsWhatThereIs) {
  Recording recording;
  break_through(recording);
  EXPECT_FALSE(found_in(recording).force_newton);
  recording.events.clear();
  add_line(recording, {.force_newton = {6.0, 0.0, 0.0}});
  add_line(recording, {});
  break_through(recording);
  EXPECT_NEAR(found_in(recording).force_newton->value, 6.0, exact);
  EXPECT_FALSE(found_in(recording).speed_mm_s);
  EXPECT_EQ(found_in(recording).plunge_mm.value, 0.0);
}

}  // namespace
}  // namespace hallux::assessment
