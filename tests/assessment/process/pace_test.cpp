#include "assessment/process/pace.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/assessment/process/made_recording.h"

namespace hallux::assessment {
namespace {

using simulator::CutEventKind;
using simulator::Recording;
using testing::add_event;
using testing::add_line;
using testing::add_lines;
using testing::running;

constexpr double exact = 1e-6;

/// Started at tick 0 and run for a second, the last fifth of it sawing.
Recording a_second() {
  Recording recording;
  add_line(recording, {.status = running});
  add_event(recording, CutEventKind::Started);
  add_lines(recording, {.status = running}, 799);
  add_lines(recording, {.status = running | testing::cutting}, 201);
  return recording;
}

TEST(Pace, RunsFromStartedToFinished) {
  Recording recording = a_second();
  EXPECT_FALSE(measure_pace(recording, {}).time_s) << "not finished yet";
  add_event(recording, CutEventKind::Finished);
  add_lines(recording, {.status = running}, 50);
  const Pace pace = measure_pace(recording, {});
  EXPECT_NEAR(pace.time_s->value, 1.0, exact);
  EXPECT_EQ(pace.time_s->first_tick, 0);
  EXPECT_EQ(pace.time_s->last_tick, 1000);
  EXPECT_NEAR(pace.planning_s->value, 0.8, exact);
  EXPECT_EQ(pace.planning_s->last_tick, 800);
}

TEST(Pace, StandsStillInAPause) {
  Recording recording = a_second();
  add_event(recording, CutEventKind::Paused);
  add_lines(recording, {}, 5000);
  add_event(recording, CutEventKind::Resumed);
  add_lines(recording, {.status = running}, 500);
  add_event(recording, CutEventKind::Finished);
  EXPECT_NEAR(measure_pace(recording, {}).time_s->value, 1.5, exact);
  Recording untold = a_second();
  add_line(untold, {.status = running, .missed = 4000});
  add_event(untold, CutEventKind::Finished);
  EXPECT_NEAR(measure_pace(untold, {}).time_s->value, 1.001, exact) << "nothing tells of the gap";
}

TEST(Pace, CountsTheTicksThatALineCovers) {
  Recording recording = a_second();
  for (const int ticks : {2, 3, 3, 1}) add_line(recording, {.status = running}, ticks);
  add_event(recording, CutEventKind::Finished);
  EXPECT_NEAR(measure_pace(recording, {}).time_s->value, 1.009, exact);
}

TEST(Pace, WithoutSawingThereIsNoPlanning) {
  Recording recording;
  add_line(recording, {.status = running});
  add_event(recording, CutEventKind::Started);
  add_lines(recording, {.status = running}, 500);
  add_event(recording, CutEventKind::Finished);
  EXPECT_FALSE(measure_pace(recording, {}).planning_s);
  EXPECT_NEAR(measure_pace(recording, {}).time_s->value, 0.5, exact);
  EXPECT_FALSE(measure_pace({}, {}).time_s);
}

HandleStretch stretch_of(std::int64_t first_tick) { return {first_tick, {}, {}}; }

void move(HandleStretch& stretch, std::size_t ticks, double speed_mm_s, std::uint32_t status = 0) {
  stretch.speed_mm_s.insert(stretch.speed_mm_s.end(), ticks, speed_mm_s);
  stretch.status.insert(stretch.status.end(), ticks, status);
}

TEST(Idle, BeginsBeyondOneAndAHalfSeconds) {
  HandleStretch stretch = stretch_of(40);
  move(stretch, 100, 30.0);
  move(stretch, 1500, 1.999);
  move(stretch, 10, 30.0);
  EXPECT_EQ(measure_pace({}, std::span(&stretch, 1)).idle_s.value, 0.0);
  move(stretch, 1501, 0.0);
  move(stretch, 10, 2.0);
  move(stretch, 2000, 1.0);
  const Finding idle = measure_pace({}, std::span(&stretch, 1)).idle_s;
  EXPECT_NEAR(idle.value, 3.501, exact);
  EXPECT_EQ(idle.first_tick, 40 + 100 + 1500 + 10 + 1501 + 10);
  EXPECT_EQ(idle.last_tick, idle.first_tick + 1999);
}

TEST(Idle, IsNotSawingAndEndsWithItsStretch) {
  HandleStretch sawing = stretch_of(0);
  move(sawing, 5000, 0.5, testing::cutting);
  EXPECT_EQ(measure_pace({}, std::span(&sawing, 1)).idle_s.value, 0.0);
  std::vector<HandleStretch> parts{stretch_of(0), stretch_of(1400)};
  for (HandleStretch& part : parts) move(part, 1400, 0.0);
  EXPECT_EQ(measure_pace({}, parts).idle_s.value, 0.0);
}

}  // namespace
}  // namespace hallux::assessment
