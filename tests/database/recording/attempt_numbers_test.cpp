#include "database/recording/attempt_numbers.h"

#include <gtest/gtest.h>

#include <map>

#include "database/course/catalogue.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Numbers : public testing::Test, protected SomeCourse {
 protected:
  std::map<AttemptId, std::int64_t> numbers_at(AttemptDesk& desk) {
    std::map<AttemptId, std::int64_t> numbers;
    for (const AttemptHeader& header : desk.attempts()) numbers[header.id] = header.number;
    return numbers;
  }
};

TEST_F(Numbers, AreTheSameAtEveryDeskAndInEveryList) {
  scored_by("bob", 10'000);
  recorded_by_robot();
  const AttemptId first = scored_by("ada", 20'000);
  scored_by("eve", 30'000);
  const AttemptId second = recorded_by("ada"), third = interrupted_of("ada");
  TraineeDesk own = trainee("ada");
  InstructorDesk kim = instructor("kim", autumn());
  for (const auto& [id, number] :
       std::map<AttemptId, std::int64_t>{{first, 1}, {second, 2}, {third, 3}}) {
    EXPECT_EQ(own.header(id).number, number);
    EXPECT_EQ(kim.header(id).number, number);
    EXPECT_EQ(numbers_at(own).at(id), number);
    EXPECT_EQ(numbers_at(kim).at(id), number);
  }
  EXPECT_EQ(kim.newest_attempts(1).at(0).number, 3) << "whatever is left out of the list";
}

TEST_F(Numbers, RunOnOverTheVersionsOfAnOperationAndAnewInAnother) {
  scored_by("ada", 20'000);
  AdministratorDesk desk = administrator();
  const auto begun_with = [&](const ScenarioText& text) {
    const ScenarioVersionId version = desk.import_scenario(text);
    desk.publish_scenario(version);
    NewAttempt attempt = attempt_of("ada");
    attempt.scenario = version;
    return trainee("ada").begin_attempt(attempt).attempt();
  };
  const AttemptId later = begun_with({"silver", 7, "{ }", false});
  const AttemptId other = begun_with({"akin", 1, "{}", false});
  EXPECT_EQ(trainee("ada").header(later).number, 2);
  EXPECT_EQ(trainee("ada").header(other).number, 1);
}

TEST_F(Numbers, StayWhatTheyWereWhenAnAttemptIsVoided) {
  const AttemptId first = scored_by("ada", 20'000), second = scored_by("ada", 30'000);
  instructor("kim", autumn()).decide({first, DecisionKind::Voided, 0, "the saw was broken"});
  EXPECT_EQ(trainee("ada").header(first).number, 1);
  EXPECT_EQ(trainee("ada").header(second).number, 2);
}

}  // namespace

}  // namespace hallux::database
