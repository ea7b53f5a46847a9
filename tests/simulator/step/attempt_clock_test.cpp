#include "simulator/step/attempt_clock.h"

#include <gtest/gtest.h>

#include "simulator/record/record.h"

namespace hallux::simulator {
namespace {

AttemptClock started() {
  AttemptClock clock;
  clock.start();
  return clock;
}

TEST(AttemptClock, RunsFromItsFirstStartToItsEnd) {
  AttemptClock clock;
  EXPECT_FALSE(clock.is_running());
  EXPECT_TRUE(clock.start());
  EXPECT_TRUE(clock.is_running());
  EXPECT_FALSE(clock.start());
  clock.end();
  EXPECT_FALSE(clock.is_running());
  EXPECT_TRUE(clock.is_over());
}

TEST(AttemptClock, MayEndBeforeItStarts) {
  AttemptClock clock;
  clock.end();
  EXPECT_TRUE(clock.is_over());
  EXPECT_FALSE(clock.awaits_tool());
}

TEST(AttemptClock, TellsOfEachPauseOnce) {
  AttemptClock clock = started();
  EXPECT_EQ(clock.pause(paused_by_operator), ClockChange::Paused);
  EXPECT_EQ(clock.pause(paused_by_operator), ClockChange::None);
  EXPECT_FALSE(clock.is_running());
  EXPECT_EQ(clock.resume(paused_by_operator), ClockChange::Resumed);
  EXPECT_EQ(clock.resume(paused_by_operator), ClockChange::None);
  EXPECT_TRUE(clock.is_running());
}

TEST(AttemptClock, RunsAgainOnlyWhenOperatorAndLoopBothLetIt) {
  AttemptClock clock = started();
  EXPECT_EQ(clock.pause(paused_by_operator), ClockChange::Paused);
  EXPECT_EQ(clock.pause(paused_by_loop), ClockChange::None);
  EXPECT_EQ(clock.resume(paused_by_loop), ClockChange::None);
  EXPECT_FALSE(clock.is_running());
  EXPECT_EQ(clock.resume(paused_by_operator), ClockChange::Resumed);
}

TEST(AttemptClock, AGapFromBeforeTheStartIsNeverTold) {
  AttemptClock clock;
  EXPECT_EQ(clock.pause(paused_by_loop), ClockChange::None);
  EXPECT_TRUE(clock.start());
  EXPECT_FALSE(clock.is_running());
  EXPECT_EQ(clock.resume(paused_by_loop), ClockChange::None);
  EXPECT_TRUE(clock.is_running());
}

TEST(AttemptClock, AwaitsTheToolOnceEvenBeyondItsEnd) {
  AttemptClock clock;
  EXPECT_FALSE(clock.awaits_tool());
  clock.start();
  clock.end();
  EXPECT_TRUE(clock.awaits_tool());
  clock.note_tool_placed();
  EXPECT_FALSE(clock.awaits_tool());
}

}  // namespace
}  // namespace hallux::simulator
