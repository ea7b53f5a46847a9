/// What a trainee is told of the others: enough people, old figures until five have changed, and
/// nobody to be made out.
#include "database/course/comparisons.h"

#include <gtest/gtest.h>

#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Comparisons : public testing::Test, protected SomeCourse {
 protected:
  PersonId person(int number) {
    const std::string login = "trainee-" + std::to_string(number);
    if (const auto known = known_person(database(), login)) return known->id;
    const PersonId id = create_person_without_password(database(), {login, "", false});
    enrol(database(), autumn(), id, CohortRole::Trainee);
    return id;
  }
  AttemptId assessed(int number, std::int64_t milli, const std::string& device = "arm") {
    NewAttempt attempt = attempt_of("ada");
    attempt.person = person(number);
    attempt.kind = AttemptKind::Assessment;
    attempt.device_class = device;
    AttemptId id = record(database(), attempt, some_recording(5));
    ScoreCard card = card_worth(milli);
    card.rubric_milli = card.measured_milli = 100'000;
    store_score(database(), id, card);
    return id;
  }
  AttemptId graded(int number, std::int64_t milli, const std::string& device = "arm") {
    AttemptId id = assessed(number, milli, device);
    decide(database(), {id, DecisionKind::Confirmed, 0, "seen"}, id_of("kim"));
    return id;
  }
  std::vector<CohortComparison> now() { return cohort_comparisons(database(), autumn(), "silver"); }
};

TEST_F(Comparisons, NeedTenPeopleAndTwentyForQuartiles) {
  for (int number = 1; number <= 9; ++number) graded(number, number * 10'000);
  EXPECT_TRUE(now().empty());
  graded(10, 100'000);
  auto shown = now();
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].people, 10);
  EXPECT_EQ(shown[0].median_milli, 55'000);
  EXPECT_FALSE(shown[0].lower_milli);
  EXPECT_FALSE(shown[0].upper_milli);
  EXPECT_EQ(shown[0].cohort_name, "autumn");
  EXPECT_EQ(shown[0].device_class, "arm");
  for (int number = 11; number <= 20; ++number) graded(number, (number - 10) * 10'000);
  shown = now();
  EXPECT_EQ(shown.at(0).people, 20);
  EXPECT_EQ(shown.at(0).lower_milli, 30'000);
  EXPECT_EQ(shown.at(0).upper_milli, 80'000);
}

TEST_F(Comparisons, StayAsTheyAreUntilFivePeopleHaveChanged) {
  for (int number = 1; number <= 10; ++number) graded(number, 50'000);
  const CohortComparison first = now().at(0);
  for (int number = 1; number <= 4; ++number) {
    graded(number, 90'000);
    EXPECT_EQ(now().at(0).median_milli, 50'000) << "after " << number;
  }
  graded(4, 91'000);
  EXPECT_EQ(now().at(0).made_utc, first.made_utc) << "one person twice is one person";
  graded(11, 90'000);
  EXPECT_EQ(now().at(0).people, 11);
  EXPECT_EQ(now().at(0).median_milli, 50'000);
  for (int number = 5; number <= 9; ++number) graded(number, 90'000);
  EXPECT_EQ(now().at(0).median_milli, 90'000);
}

TEST_F(Comparisons, KeepDeviceClassesAndTheNewestResultOfEachPersonApart) {
  for (int number = 1; number <= 10; ++number) {
    graded(number, 20'000);
    graded(number, 70'000);
    graded(number, 30'000, "mouse");
  }
  const auto shown = now();
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[0].device_class, "arm");
  EXPECT_EQ(shown[0].median_milli, 70'000);
  EXPECT_EQ(shown[1].device_class, "mouse");
  EXPECT_EQ(shown[1].median_milli, 30'000);
}

TEST_F(Comparisons, LeaveOutWhatIsNoGrade) {
  for (int number = 1; number <= 9; ++number) graded(number, 50'000);
  assessed(10, 50'000);  // nobody confirmed it
  const AttemptId voided = graded(11, 50'000);
  decide(database(), {voided, DecisionKind::Voided, 0, "the power went"}, id_of("kim"));
  const AttemptId not_valid = graded(12, 50'000);
  tamper(database(), "UPDATE attempt SET is_valid = 0 WHERE uuid = '" + not_valid.text + "'");
  const AttemptId simulated = graded(13, 50'000);
  tamper(database(), "UPDATE attempt SET is_simulated = 1 WHERE uuid = '" + simulated.text + "'");
  const AttemptId imported = graded(14, 50'000);
  tamper(database(), "INSERT INTO origin (directory_uuid, imported_utc) VALUES ('" +
                         std::string(32, 'a') + "', ''); UPDATE attempt SET origin_id = 1 " +
                         "WHERE uuid = '" + imported.text + "'");
  store_score(database(), recorded_by_robot(), card_worth(50'000));
  EXPECT_TRUE(now().empty());
  tamper(database(), "UPDATE origin SET is_accepted = 1");
  EXPECT_EQ(now().at(0).people, 10);
}

TEST_F(Comparisons, AreToldToTraineesOfTheirOwnCohortsAndToItsInstructors) {
  for (int number = 1; number <= 10; ++number) graded(number, 50'000);
  EXPECT_EQ(trainee("ada").cohort_comparisons("silver").size(), 1U);
  EXPECT_TRUE(trainee("eve").cohort_comparisons("silver").empty());
  EXPECT_TRUE(trainee("kim").cohort_comparisons("silver").empty()) << "is no trainee there";
  EXPECT_EQ(instructor("kim", autumn()).cohort_comparisons("silver").size(), 1U);
  EXPECT_TRUE(instructor("lee", spring()).cohort_comparisons("silver").empty());
}

TEST_F(Comparisons, KeepWhoWasErased) {
  for (int number = 1; number <= 10; ++number) graded(number, 50'000);
  EXPECT_EQ(now().at(0).people, 10);
  tamper(database(), "DELETE FROM person_detail WHERE login LIKE 'trainee-%'");
  EXPECT_EQ(now().at(0).people, 10);
}

TEST(Quantiles, LieOnTheLineBetweenTwoValues) {
  EXPECT_DOUBLE_EQ(quantile({7.0}, 0.25), 7.0);
  EXPECT_DOUBLE_EQ(quantile({1.0, 2.0}, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(quantile({1.0, 2.0, 3.0, 4.0, 5.0}, 0.25), 2.0);
  EXPECT_DOUBLE_EQ(quantile({1.0, 2.0, 3.0, 4.0}, 0.75), 3.25);
  EXPECT_DOUBLE_EQ(quantile({1.0, 9.0}, 1.0), 9.0);
}

}  // namespace

}  // namespace hallux::database
