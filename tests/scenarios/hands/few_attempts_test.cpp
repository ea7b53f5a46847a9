// A few attempts of both hands at each shipped operation, from the first touch to a replayed score.
#include <gtest/gtest.h>

#include "tests/scenarios/hands/attempt_table.h"

namespace hallux::tests {
namespace {

void expect_that_a_few_tell(const char* scenario, std::size_t seeds) {
  const AttemptTable table = run_attempts(scenario, seeds);
  expect_sound(table);
  for (const AttemptRow& expert : table.rows[0]) EXPECT_TRUE(expert.freed_a_piece);
  EXPECT_GT(median(table.rows[0], &AttemptRow::score), median(table.rows[1], &AttemptRow::score));
  EXPECT_LT(median(table.rows[0], &AttemptRow::hot_patches),
            median(table.rows[1], &AttemptRow::hot_patches));
}

TEST(FewAttempts, AtSilverAreScoredAndReplayIdentically) { expect_that_a_few_tell("silver", 2); }

TEST(FewAttempts, AtAkinAreScoredAndReplayIdentically) { expect_that_a_few_tell("akin", 1); }

}  // namespace
}  // namespace hallux::tests
