#include "simulator/record/tape_lines.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace hallux::simulator {
namespace {

Recording of_lines(std::int64_t count) {
  Recording recording;
  for (std::int64_t tick = 0; tick < count; ++tick) recording.tape.emplace_back().tick = tick;
  return recording;
}

std::vector<TapeLine> visited(const TapeLines& lines) {
  std::vector<TapeLine> seen;
  lines.visit([&](const TapeLine& line) { seen.push_back(line); });
  return seen;
}

TEST(TapeLines, OfARecordingAreItsOwnInTheirOrderEachTime) {
  const Recording recording = of_lines(5);
  const TapeLines lines = tape_of(recording);
  EXPECT_EQ(lines.count(), 5U);
  EXPECT_EQ(visited(lines), recording.tape);
  EXPECT_EQ(visited(lines), recording.tape);
}

TEST(TapeLines, NoneAreNotVisited) {
  EXPECT_TRUE(visited({}).empty());
  EXPECT_TRUE(visited(tape_of(Recording())).empty());
}

TEST(TapeLines, WhatAVisitThrowsEndsIt) {
  const Recording recording = of_lines(5);
  int seen = 0;
  EXPECT_THROW(tape_of(recording).visit([&](const TapeLine&) {
    if (++seen == 3) throw std::runtime_error("enough");
  }),
               std::runtime_error);
  EXPECT_EQ(seen, 3);
}

TEST(Recorded, HasItsOwnTapeOrTheOneThatIsKeptElsewhere) {
  const Recording whole = of_lines(5), other = of_lines(2);
  EXPECT_EQ(visited(Recorded(whole).tape), whole.tape);
  EXPECT_EQ(visited(Recorded(other, tape_of(whole)).tape), whole.tape);
}

}  // namespace
}  // namespace hallux::simulator
