// The forty scripted Akin attempts: what the two hands score, what is left of the hinge, and that
// each replays.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenarios/hands/attempt_table.h"

namespace hallux::tests {
namespace {

// One test, because each test runs in a process of its own and the attempts take minutes.
TEST(AkinAttempts, TellAnExpertFromANoviceAndReplayIdentically) {
  const AttemptTable table = run_attempts("akin");
  expect_told_apart(table);
  const auto& [expert, novice] = table.rows;
  // Wedges come free and close in most experts' hands; in a part of the novices' the lateral cortex
  // gives way.
  EXPECT_GE(std::count_if(expert.begin(), expert.end(),
                          [](const AttemptRow& row) { return row.freed_a_piece; }),
            18);
  EXPECT_GE(std::count_if(expert.begin(), expert.end(),
                          [](const AttemptRow& row) { return row.closed_hinge; }),
            15);
  const auto lost = std::count_if(novice.begin(), novice.end(),
                                  [](const AttemptRow& row) { return row.hinge_mm <= 0.0; });
  EXPECT_GE(lost, 4);
  EXPECT_LE(lost, 16);
}

}  // namespace
}  // namespace hallux::tests
