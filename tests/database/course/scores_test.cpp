#include "database/course/scores.h"

#include <gtest/gtest.h>

#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

ScoreCard card_worth(std::int64_t score_milli, std::int32_t rubric_version) {
  ScoreCard card;
  card.score_milli = score_milli;
  card.rubric_version = rubric_version;
  return card;
}

TEST(Scores, AreSupersededNotOverwritten) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId id = record(database, some_attempt(database), some_recording(10));
  EXPECT_FALSE(load_score(database, id));
  store_score(database, id, card_worth(61'000, 1));
  const ScoreId second = store_score(database, id, card_worth(64'500, 2));
  EXPECT_EQ(load_score(database, id)->id, second);
  EXPECT_EQ(load_header(database, id).score_milli, 64'500);
  const auto all = kept_scores(database, id);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_FALSE(all[1].is_in_force);
  EXPECT_EQ(all[1].score_milli, 61'000);
  EXPECT_ANY_THROW(tamper(database, "UPDATE score SET score_milli = 100000"));
}

TEST(Scores, ThatAreTheSameAreStoredOnce) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId id = record(database, some_attempt(database), some_recording(10));
  const ScoreId first = store_score(database, id, card_worth(61'000, 1));
  EXPECT_EQ(store_score(database, id, card_worth(61'000, 1)), first);
  EXPECT_EQ(kept_scores(database, id).size(), 1U);
}

}  // namespace

}  // namespace hallux::database
