#include "database/course/simulated_course.h"

#include <gtest/gtest.h>

#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

TEST(SimulatedCourse, MarksEveryAttemptMadeInIt) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  EXPECT_FALSE(is_simulated_course(database));
  mark_as_simulated_course(database);
  EXPECT_TRUE(is_simulated_course(database));
  const PersonId person = create_person_without_password(database, {"trainee-1", "", false});
  NewAttempt attempt = some_attempt(database);
  attempt.person = person;
  attempt.kind = AttemptKind::Assessment;
  AttemptHeader header = load_header(database, record(database, attempt, some_recording(5)));
  EXPECT_TRUE(header.is_simulated);
  header.begun.hand = "";
  header.is_complete = true;
  header.is_valid = true;
  header.decided_milli = 90'000;
  header.decision_is_of_score_in_force = true;
  EXPECT_FALSE(is_grade(header));
  header.is_simulated = false;
  EXPECT_TRUE(is_grade(header)) << "so it was the mark that kept it from being one";
}

TEST(SimulatedCourse, IsMarkedBeforeAnybodyIsInItAndForGood) {
  SomeCourse course;
  EXPECT_EQ(kind_thrown([&] { mark_as_simulated_course(course.database()); }),
            DatabaseErrorKind::Refused);
  EXPECT_FALSE(is_simulated_course(course.database()));
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  mark_as_simulated_course(database);
  EXPECT_ANY_THROW(tamper(database, "DELETE FROM simulated_course"));
  EXPECT_ANY_THROW(tamper(database, "UPDATE simulated_course SET marked_utc = ''"));
}

TEST(SimulatedCourse, IsNotMadeOfTheRobotsAttempts) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record(database, some_attempt(database), some_recording(5));
  EXPECT_EQ(kind_thrown([&] { mark_as_simulated_course(database); }), DatabaseErrorKind::Refused);
}

}  // namespace

}  // namespace hallux::database
