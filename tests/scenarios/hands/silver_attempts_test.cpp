// The forty scripted Silver attempts: what the two hands score, how far off they really cut, and
// that each replays.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenarios/hands/attempt_table.h"

namespace hallux::tests {
namespace {

// One test, because each test runs in a process of its own and the attempts take minutes. Of the
// expert's seed 3 the face runs along the shaft: a piece of the shaft's side comes free after the
// eminence.
TEST(SilverAttempts, TellAnExpertFromANoviceAndReplayIdentically) {
  const AttemptTable table = run_attempts("silver");
  expect_told_apart(table);
  for (const AttemptRows& rows : table.rows) {
    EXPECT_GE(std::count_if(rows.begin(), rows.end(),
                            [](const AttemptRow& row) { return row.freed_a_piece; }),
              18);
  }
}

}  // namespace
}  // namespace hallux::tests
