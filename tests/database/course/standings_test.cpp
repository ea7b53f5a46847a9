/// What is kept of how people stand, by example; random courses are in standings_property_test.cpp.
#include "database/course/standings.h"

#include <gtest/gtest.h>

#include "database/maintenance/verify.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Standings : public testing::Test, protected SomeCourse {};

TEST_F(Standings, NameThePersonWhereOneWasAltered) {
  scored_by("ada", 61'000);
  EXPECT_NO_THROW(check_standings(database()));
  tamper(database(), "UPDATE standing SET best_milli = 99000");
  const std::string person = "person " + std::to_string(id_of("ada").number);
  try {
    check_standings(database());
    ADD_FAILURE() << "an altered row was not found";
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::Damaged);
    EXPECT_NE(std::string{error.what()}.find(person + " stands in silver"), std::string::npos);
  }
  recount_standings(database());
  EXPECT_NO_THROW(check_standings(database()));
}

TEST_F(Standings, NameTheScoreWhereWhatWasReadOfItsCardWasAltered) {
  scored_by("ada", 61'000);
  tamper(database(), "UPDATE score SET is_gated = 1");
  const Verification found = verify(database());
  EXPECT_NE(found.first_damage.value_or("").find("score 1"), std::string::npos);
}

TEST_F(Standings, SayOfACardWhetherItPassesAsTheCardItselfDoes) {
  NewAttempt attempt = attempt_of("ada");
  attempt.kind = AttemptKind::Assessment;
  const AttemptId id = record(database(), attempt, some_recording(5));
  ScoreCard card = card_worth(77'000);
  card.rubric_milli = 100'000;
  card.measured_milli = 90'000;
  card.groups = {{"accuracy", 78'000, 68'000, 60'000}, {"safety", 22'000, 22'000, 17'000}};
  card.gates = {{"hinge", 69'000, false, 0.0, 0.0, "mm", ""},
                {"plunge", 59'000, true, 3.0, 2.0, "mm", ""}};
  store_score(database(), id, card);
  const auto standings = operation_standings(database(), id_of("ada"));
  ASSERT_EQ(standings.size(), 1U);
  ASSERT_EQ(standings[0].by_device.size(), 1U);
  const AssessedRun& run = standings[0].by_device[0].runs.at(0);
  EXPECT_EQ(run.standing_milli, 77'000);
  EXPECT_GT(run.begun_s, 1'700'000'000);
  EXPECT_EQ(run.pass.measured_milli, 90'000);
  EXPECT_EQ(run.pass.rubric_milli, 100'000);
  EXPECT_EQ(run.pass.safety_measured_milli, 22'000);
  EXPECT_EQ(run.pass.safety_earned_milli, 17'000);
  EXPECT_TRUE(run.pass.is_gated);
}

TEST_F(Standings, ShowTheNewestAttemptsOfTheWholeCohort) {
  scored_by("ada", 61'000);
  const AttemptId second = scored_by("bob", 62'000);
  const AttemptId third = scored_by("ada", 63'000);
  scored_by("eve", 64'000);
  const auto newest = instructor("kim", autumn()).newest_attempts(2);
  ASSERT_EQ(newest.size(), 2U);
  EXPECT_EQ(newest[0].id, third);
  EXPECT_EQ(newest[1].id, second);
  EXPECT_EQ(instructor("kim", autumn()).trainee(id_of("ada"), 1).last_attempts.at(0).id, third);
  EXPECT_EQ(kind_thrown([&] { instructor("kim", autumn()).trainee(id_of("eve")); }),
            DatabaseErrorKind::Refused);
}

}  // namespace

}  // namespace hallux::database
