#include "simulator/record/drain.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

TEST(Drain, TakesAllThatWaitsInItsOrderAndSaysWhetherThereWasAny) {
  AttemptChannels channels(8);
  Recording recording;
  EXPECT_FALSE(drain(channels, recording));
  for (std::int64_t tick = 0; tick < 6; ++tick) {
    TapeLine line;
    line.tick = tick;
    ASSERT_TRUE(channels.tape.push(line));
    ToolSample sample;
    sample.tick = tick;
    ASSERT_TRUE(channels.samples.push(sample));
    if (tick % 3 == 2) {
      EXPECT_TRUE(drain(channels, recording));
    }
  }
  CutEvent event;
  event.kind = CutEventKind::Finished;
  ASSERT_TRUE(channels.events.push(event));
  EXPECT_TRUE(drain(channels, recording)) << "events alone are something";
  EXPECT_FALSE(drain(channels, recording));
  ASSERT_EQ(recording.tape.size(), 6U);
  ASSERT_EQ(recording.samples.size(), 6U);
  ASSERT_EQ(recording.events.size(), 1U);
  for (std::int64_t tick = 0; tick < 6; ++tick) {
    EXPECT_EQ(recording.tape[static_cast<std::size_t>(tick)].tick, tick);
    EXPECT_EQ(recording.samples[static_cast<std::size_t>(tick)].tick, tick);
  }
}

}  // namespace
}  // namespace hallux::simulator
