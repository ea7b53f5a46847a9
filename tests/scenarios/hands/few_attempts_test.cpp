// A few attempts of both hands at each shipped operation, from the first touch to a replayed score.
#include <gtest/gtest.h>

#include "tests/scenarios/hands/attempt_table.h"

namespace hallux::tests {
namespace {

void expect_that_a_few_tell(const char* scenario) {
  const AttemptTable table = run_attempts(scenario, 2);
  expect_sound(table);
  for (const AttemptRow& expert : table.rows[0]) EXPECT_TRUE(expert.freed_a_piece);
  EXPECT_GT(median(table.rows[0], &AttemptRow::score), median(table.rows[1], &AttemptRow::score));
  EXPECT_LT(median(table.rows[0], &AttemptRow::hot_patches),
            median(table.rows[1], &AttemptRow::hot_patches));
}

TEST(FewAttempts, AtSilverAreScoredAndReplayIdentically) { expect_that_a_few_tell("silver"); }

TEST(FewAttempts, AtAkinAreScoredAndReplayIdentically) { expect_that_a_few_tell("akin"); }

// The face of this seed runs along the shaft: a piece of the shaft's side comes free after the
// eminence.
TEST(FewAttempts, AtSilverAnExpertTakesOutAllThatTheFaceFrees) {
  const AttemptRow row = run_attempt_of("silver", "expert", 3);
  EXPECT_TRUE(row.is_done);
  EXPECT_GT(row.score, 75.0);
  EXPECT_TRUE(row.is_identical);
}

}  // namespace
}  // namespace hallux::tests
