#include "assessment/process/handle_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/assessment/process/made_recording.h"

namespace hallux::assessment {
namespace {

using simulator::Recording;
using testing::add_line;
using testing::running;

constexpr double exact = 1e-6;
/// A straight way is even again after so many ticks: the filter begins at rest a tenth of a second
/// before, and what is left of that falls by e in 22.5 ms.
constexpr std::size_t settled_ticks = 300;

/// 0.02 mm a tick along a slanted line, in lines of so many ticks.
void go(Recording& recording, int lines, int ticks, double& way_mm) {
  for (int line = 0; line < lines; ++line) {
    way_mm += 0.02 * ticks;
    add_line(recording, {.status = running, .tip_mm = way_mm * Vec3{0.6, 0.0, -0.8}}, ticks);
  }
}

TEST(HandleTrack, TheSpeedOfAnEvenWayIsThatWay) {
  Recording recording;
  double way_mm = 0.0;
  go(recording, 1000, 1, way_mm);
  const std::vector<HandleStretch> stretches = handle_stretches(recording);
  ASSERT_EQ(stretches.size(), 1U);
  ASSERT_EQ(stretches[0].speed_mm_s.size(), 1000U);
  for (std::size_t index = settled_ticks; index < 1000 - settled_ticks; ++index)
    EXPECT_NEAR(stretches[0].speed_mm_s[index], 20.0, 1e-3) << index;
  for (const double speed_mm_s : stretches[0].speed_mm_s) EXPECT_NEAR(speed_mm_s, 20.0, 0.5);
}

TEST(HandleTrack, ALineOfThreeTicksIsThreeEvenOnes) {
  Recording recording;
  double way_mm = 0.0;
  go(recording, 1, 1, way_mm);
  go(recording, 333, 3, way_mm);
  const std::vector<HandleStretch> stretches = handle_stretches(recording);
  ASSERT_EQ(stretches.size(), 1U);
  ASSERT_EQ(stretches[0].speed_mm_s.size(), 1000U);
  ASSERT_EQ(stretches[0].status.size(), 1000U);
  EXPECT_NEAR(stretches[0].speed_mm_s[500], 20.0, 1e-3);
}

TEST(HandleTrack, AHandleAtRestHasNoSpeed) {
  Recording recording;
  testing::add_lines(recording, {.status = running, .tip_mm = {3.0, -40.0, 7.5}}, 500);
  const std::vector<HandleStretch> stretches = handle_stretches(recording);
  ASSERT_EQ(stretches.size(), 1U);
  for (const double speed_mm_s : stretches[0].speed_mm_s) EXPECT_NEAR(speed_mm_s, 0.0, exact);
}

TEST(HandleTrack, APauseAndAGapEndAStretch) {
  Recording recording;
  double way_mm = 0.0;
  go(recording, 10, 1, way_mm);
  testing::add_lines(recording, {}, 5);
  go(recording, 20, 1, way_mm);
  add_line(recording, {.status = running, .missed = 1});
  go(recording, 30, 1, way_mm);
  const std::vector<HandleStretch> stretches = handle_stretches(recording);
  ASSERT_EQ(stretches.size(), 3U);
  EXPECT_EQ(stretches[0].first_tick, 0);
  EXPECT_EQ(stretches[0].speed_mm_s.size(), 10U);
  EXPECT_EQ(stretches[1].first_tick, 15);
  EXPECT_EQ(stretches[1].tick_at(19), 34);
  EXPECT_EQ(stretches[2].first_tick, 36);
  EXPECT_EQ(stretches[2].speed_mm_s.size(), 31U);
}

TEST(HandleTrack, WithoutATapeOrOfOneLineItTellsNoSpeed) {
  Recording recording;
  EXPECT_TRUE(handle_stretches(recording).empty());
  add_line(recording, {.status = running});
  ASSERT_EQ(handle_stretches(recording).size(), 1U);
  EXPECT_EQ(handle_stretches(recording)[0].speed_mm_s, std::vector<double>{0.0});
  recording.tape.clear();
  EXPECT_TRUE(handle_stretches(recording).empty());
}

TEST(HandleTrack, ATapeThatIsKeptElsewhereTellsTheSame) {
  Recording recording;
  double way_mm = 0.0;
  go(recording, 700, 1, way_mm);
  go(recording, 5, 3, way_mm);
  const std::vector<HandleStretch> expected = handle_stretches(recording);
  Recording elsewhere;
  std::swap(elsewhere.tape, recording.tape);
  const std::vector<HandleStretch> made =
      handle_stretches(simulator::Recorded(recording, tape_of(elsewhere)));
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0].speed_mm_s, expected.at(0).speed_mm_s);
  EXPECT_EQ(made[0].status, expected[0].status);
}

TEST(HandleTrack, RunsAreTheLongestOfTheirKind) {
  HandleStretch stretch{.first_tick = 7, .speed_mm_s = {9, 9, 1, 9, 1, 1, 9}, .status = {}};
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for_each_run(
      stretch, [&](std::size_t index) { return stretch.speed_mm_s[index] > 5.0; },
      [&](std::size_t first, std::size_t last) { runs.emplace_back(first, last); });
  const std::vector<std::pair<std::size_t, std::size_t>> expected{{0, 1}, {3, 3}, {6, 6}};
  EXPECT_EQ(runs, expected);
}

}  // namespace
}  // namespace hallux::assessment
