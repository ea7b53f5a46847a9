/// How many assessments a cohort allows, and which of them count.
#include "database/course/limits.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "database/audit/audit.h"
#include "database/course/begin_attempt.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Limits : public testing::Test, protected SomeCourse {
 protected:
  NewAttempt assessment_of(const std::string& login) {
    NewAttempt attempt = attempt_of(login);
    attempt.kind = AttemptKind::Assessment;
    return attempt;
  }
  AttemptId assessed(const std::string& login) {
    AttemptId id = record(database(), assessment_of(login), some_recording(5));
    store_score(database(), id, card_worth(60'000));
    return id;
  }
  /// Its writer is gone after so many milliseconds.
  void interrupted_after(std::int64_t ticks) {
    {
      simulator::AttemptChannels channels{4096};
      Recorder recorder{database(), create_attempt(database(), assessment_of("ada")), channels};
      produce(some_recording(ticks), channels);
      recorder.drain();
    }
    database().open_again();
  }
  std::int32_t left() { return trainee("ada").operations().at(0).allowance->left(); }
};

TEST_F(Limits, LeaveAsManyAsTheyLikeWhereNoneIsSet) {
  assessed("ada");
  EXPECT_FALSE(trainee("ada").operations().at(0).allowance);
}

TEST_F(Limits, RefuseTheNextAssessmentAndSayWhoCanChangeIt) {
  instructor("kim", autumn()).set_limit("silver", 2);
  assessed("ada");
  EXPECT_EQ(left(), 1);
  assessed("ada");
  EXPECT_EQ(left(), 0);
  try {
    trainee("ada").begin_attempt(assessment_of("ada"));
    ADD_FAILURE() << "a third assessment was begun";
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::Refused);
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("used 2 of the 2 assessments of 'silver'"), std::string::npos);
    EXPECT_NE(sentence.find("cohort autumn"), std::string::npos);
    EXPECT_NE(sentence.find("instructors and the administrators can change"), std::string::npos);
  }
  EXPECT_TRUE(last_audit().was_refused);
  EXPECT_EQ(last_audit().action, "begin_attempt");
  EXPECT_NO_THROW(trainee("bob").begin_attempt(assessment_of("bob"))) << "each has their own";
  EXPECT_NO_THROW(trainee("ada").begin_attempt(attempt_of("ada"))) << "practice is not limited";
  administrator().set_limit(autumn(), "silver", 3);
  EXPECT_NO_THROW(trainee("ada").begin_attempt(assessment_of("ada")));
}

TEST_F(Limits, AreNotUsedUpByWhatIsVoidOrNotValid) {
  instructor("kim", autumn()).set_limit("silver", 1);
  const AttemptId id = assessed("ada");
  instructor("kim", autumn()).decide({id, DecisionKind::Voided, 0, "the power went"});
  EXPECT_EQ(left(), 1);
  instructor("kim", autumn()).decide({id, DecisionKind::Confirmed, 0, "it was whole"});
  EXPECT_EQ(left(), 0);
  tamper(database(), "UPDATE attempt SET is_valid = 0");
  EXPECT_EQ(left(), 1);
}

TEST_F(Limits, AreUsedUpByAnInterruptedOneOnlyOnceTheBladeTouchedBone) {
  instructor("kim", autumn()).set_limit("silver", 5);
  interrupted_after(50);
  EXPECT_EQ(left(), 5) << "nothing was touched";
  interrupted_after(1000);
  EXPECT_EQ(left(), 4) << "nobody closes the window on a bad cut";
  tamper(database(), "UPDATE chunk SET bytes = x'00' WHERE stream = 2");
  EXPECT_EQ(left(), 4) << "what cannot be read counts";
}

TEST_F(Limits, AreUsedUpByWhatIsBeingRecorded) {
  instructor("kim", autumn()).set_limit("silver", 1);
  TraineeDesk desk = trainee("ada");
  const WriterLease first = desk.begin_attempt(assessment_of("ada"));
  EXPECT_EQ(kind_thrown([&] { desk.begin_attempt(assessment_of("ada")); }),
            DatabaseErrorKind::Refused);
}

TEST_F(Limits, GiveTheLastOneToOneOfTwoWindows) {
  instructor("kim", autumn()).set_limit("silver", 1);
  const NewAttempt attempt = assessment_of("ada");
  int begun = 0, refused = 0;
  for (int round = 0; round < 5; ++round) {
    std::atomic<int> begun_now = 0, refused_now = 0;
    const auto begin = [&](Database window) {
      try {
        const WriterLease lease = create_attempt(window, attempt);
        ++begun_now;
      } catch (const DatabaseError& error) {
        EXPECT_EQ(error.kind(), DatabaseErrorKind::Refused) << error.what();
        ++refused_now;
      }
    };
    // Both are open before either begins: an opening would find the first one's attempt
    // interrupted.
    Database one_window = database().open_again(), other_window = database().open_again();
    { const std::jthread one(begin, std::move(one_window)), other(begin, std::move(other_window)); }
    begun += begun_now;
    refused += refused_now;
    tamper(database(), "UPDATE attempt SET state = 'void' WHERE state <> 'closed'");
  }
  EXPECT_EQ(begun, 5);
  EXPECT_EQ(refused, 5);
}

TEST_F(Limits, AreTheStrictestOfThePersonsCohortsAndCountFromTheEnrolment) {
  assessed("ada");
  administrator().enrol(spring(), "ada", CohortRole::Trainee);
  administrator().set_limit(autumn(), "silver", 3);
  administrator().set_limit(spring(), "silver", 1);
  const auto allowance = *trainee("ada").operations().at(0).allowance;
  EXPECT_EQ(allowance.cohort_name, "spring");
  EXPECT_EQ(allowance.used, 0) << "begun before she came into spring";
  EXPECT_EQ(allowance.left(), 1);
  administrator().clear_limit(spring(), "silver");
  EXPECT_EQ(trainee("ada").operations().at(0).allowance->used, 1);
  administrator().enrol(autumn(), "ada", CohortRole::Trainee);
  EXPECT_EQ(trainee("ada").operations().at(0).allowance->used, 1)
      << "the same role again changes nothing";
}

TEST_F(Limits, AreSetWithinBoundsForWhatThereIsAndAudited) {
  InstructorDesk desk = instructor("kim", autumn());
  EXPECT_EQ(kind_thrown([&] { desk.set_limit("silver", 0); }), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_thrown([&] { desk.set_limit("silver", 1001); }), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_thrown([&] { desk.set_limit("gold", 1); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] { desk.clear_limit("silver"); }), DatabaseErrorKind::NotFound);
  desk.set_limit("silver", 2);
  EXPECT_EQ(last_audit().action, "limit_set");
  EXPECT_EQ(last_audit().subject_id, std::to_string(autumn().number) + "/silver/2");
  const auto limits = desk.limits();
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_EQ(limits[0].attempts_max, 2);
  EXPECT_EQ(limits[0].set_by, "kim");
  desk.clear_limit("silver");
  EXPECT_EQ(last_audit().action, "limit_cleared");
  EXPECT_TRUE(desk.limits().empty());
}

}  // namespace

}  // namespace hallux::database
