#include "database/desks/desks.h"

#include <gtest/gtest.h>

#include "database/audit/audit.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Desks : public testing::Test, protected SomeCourse {};

TEST_F(Desks, AreHadByRoleOnly) {
  Session ada = sign_in_as("ada");
  EXPECT_TRUE(ada.trainee());
  EXPECT_FALSE(ada.instructor_of(autumn()));
  EXPECT_FALSE(ada.administrator());
  Session kim = sign_in_as("kim");
  EXPECT_TRUE(kim.instructor_of(autumn()));
  EXPECT_FALSE(kim.instructor_of({99}));
  EXPECT_FALSE(kim.administrator());
  EXPECT_TRUE(sign_in_as("root").administrator());
}

TEST_F(Desks, ShowATraineeTheirOwnAttemptsAndTheRobots) {
  const AttemptId own = recorded_by("ada");
  const AttemptId other = recorded_by("bob");
  const AttemptId robot = record(database(), some_attempt(database()), some_recording(5));
  TraineeDesk desk = *sign_in_as("ada").trainee();
  const auto listed = desk.attempts();
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_EQ(listed[0].id, robot);
  EXPECT_EQ(listed[1].id, own);
  EXPECT_EQ(desk.recording(own).samples.size(), 5U);
  EXPECT_EQ(kind_thrown([&] { desk.header(other); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] { desk.recording(other); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] { desk.score(other); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] { desk.store_score(other, {}); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] { desk.begin_attempt(attempt_of("bob")); }),
            DatabaseErrorKind::Refused);
}

TEST_F(Desks, SayWhetherAScoreMayBeStoredWithoutARefusalInTheAudit) {
  const AttemptId own = recorded_by("ada");
  const AttemptId robot = record(database(), some_attempt(database()), some_recording(5));
  TraineeDesk desk = *sign_in_as("ada").trainee();
  const std::size_t audited = read_audit(database()).size();
  EXPECT_TRUE(desk.may(Action::StoreScore, desk.header(own)));
  EXPECT_FALSE(desk.may(Action::StoreScore, desk.header(robot)));
  EXPECT_TRUE(HouseDesk(database()).may(Action::StoreScore, desk.header(robot)));
  EXPECT_EQ(read_audit(database()).size(), audited);
}

TEST_F(Desks, ShowAnInstructorTheirCohortAndNoOther) {
  const AttemptId of_cohort = recorded_by("ada");
  const AttemptId of_other_cohort = recorded_by("eve");
  InstructorDesk desk = *sign_in_as("kim").instructor_of(autumn());
  ASSERT_EQ(desk.attempts().size(), 1U);
  EXPECT_EQ(desk.attempts()[0].id, of_cohort);
  EXPECT_EQ(desk.recording(of_cohort).samples.size(), 5U);
  EXPECT_EQ(read_audit(database()).back().entry.action, "attempt_viewed");
  EXPECT_EQ(kind_thrown([&] { desk.recording(of_other_cohort); }), DatabaseErrorKind::NotFound);
  const AuditRow last = read_audit(database()).back();
  EXPECT_TRUE(last.entry.was_refused);
  EXPECT_EQ(last.entry.actor, find_person(database(), "kim").id);
}

TEST_F(Desks, OfAnAdministratorKeepTheRobotsScoresAndSeeNobodysAttempt) {
  const AttemptId of_ada = recorded_by("ada");
  const AttemptId robot = record(database(), some_attempt(database()), some_recording(5));
  AdministratorDesk desk = *sign_in_as("root").administrator();
  ASSERT_EQ(desk.attempts().size(), 1U);
  EXPECT_EQ(desk.attempts()[0].id, robot);
  const ScoreId stored = desk.store_score(robot, {});
  EXPECT_EQ(desk.score(robot)->id, stored);
  const AuditEntry last = read_audit(database()).back().entry;
  EXPECT_EQ(last.action, "score_stored");
  EXPECT_EQ(last.actor, find_person(database(), "root").id);
  EXPECT_EQ(kind_thrown([&] { desk.header(of_ada); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] { desk.store_score(of_ada, {}); }), DatabaseErrorKind::NotFound);
}

TEST_F(Desks, AreChosenByWhatTheTableAllowsOnTheAttempt) {
  const AttemptId of_ada = recorded_by("ada");
  const AttemptId of_root = recorded_by("root");
  const AttemptId robot = record(database(), some_attempt(database()), some_recording(5));
  const auto may_store = [&](const char* login, const AttemptId& id) {
    Session session = sign_in_as(login);
    const std::size_t audited = read_audit(database()).size();
    const bool may = session.desk_for(Action::StoreScore, id)
                         ->may(Action::StoreScore, load_header(database(), id));
    EXPECT_EQ(read_audit(database()).size(), audited);
    return may;
  };
  EXPECT_TRUE(may_store("root", robot));
  EXPECT_TRUE(may_store("root", of_root));
  EXPECT_FALSE(may_store("root", of_ada));
  EXPECT_TRUE(may_store("kim", robot));
  EXPECT_TRUE(may_store("kim", of_ada));
  EXPECT_FALSE(may_store("kim", of_root));
  EXPECT_TRUE(may_store("ada", of_ada));
  EXPECT_FALSE(may_store("ada", robot));
  EXPECT_FALSE(may_store("bob", of_ada));
  Session bob = sign_in_as("bob");
  EXPECT_EQ(kind_thrown([&] { bob.desk_for(Action::ViewAttempt, of_ada)->header(of_ada); }),
            DatabaseErrorKind::NotFound);
  sign_in_as("root").administrator()->set_disabled("bob", true);
  EXPECT_FALSE(bob.desk_for(Action::ViewAttempt, robot));
}

TEST_F(Desks, OfTheHouseHoldOnlyWhatIsNobodys) {
  const AttemptId of_ada = recorded_by("ada");
  const AttemptId robot = record(database(), some_attempt(database()), some_recording(5));
  HouseDesk desk{database()};
  ASSERT_EQ(desk.attempts().size(), 1U);
  EXPECT_EQ(desk.attempts()[0].id, robot);
  EXPECT_EQ(kind_thrown([&] { desk.header(of_ada); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] { desk.begin_attempt(attempt_of("ada")); }),
            DatabaseErrorKind::Refused);
}

TEST_F(Desks, StopWorkingWhenTheRightToThemEnds) {
  Session session = sign_in_as("kim");
  InstructorDesk desk = *session.instructor_of(autumn());
  sign_in_as("root").administrator()->set_disabled("kim", true);
  EXPECT_EQ(kind_thrown([&] { desk.attempts(); }), DatabaseErrorKind::Refused);
  EXPECT_FALSE(session.instructor_of(autumn()));
  EXPECT_FALSE(session.trainee());
}

TEST_F(Desks, OfAnAdministratorSetPasswords) {
  AdministratorDesk desk = *sign_in_as("root").administrator();
  desk.set_password("ada", secret("another long phrase"), cheap);
  EXPECT_EQ(kind_thrown([&] { sign_in_as("ada"); }), DatabaseErrorKind::Refused);
  EXPECT_NO_THROW(sign_in(database(), "ada", secret("another long phrase"), cheap));
  EXPECT_EQ(desk.people().size(), 7U);
}

TEST_F(Desks, SignInSaysTheSameForAWrongPasswordAndAnUnknownLogin) {
  const auto sentence = [&](const char* login) {
    try {
      sign_in(database(), login, secret("not the password"), cheap);
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::Refused);
      return std::string{error.what()};
    }
    return std::string{};
  };
  std::string known = sentence("ada");
  EXPECT_EQ(known.replace(known.find("ada"), 3, "zoe"), sentence("zoe"));
  EXPECT_TRUE(read_audit(database()).back().entry.was_refused);
}

TEST_F(Desks, PasswordsAreChangedByThoseWhoKnowTheOldOne) {
  Session ada = sign_in_as("ada");
  EXPECT_EQ(kind_thrown([&] {
              ada.change_password(secret("not the password"), secret("another long phrase"), cheap);
            }),
            DatabaseErrorKind::Refused);
  ada.change_password(secret(good_password), secret("another long phrase"), cheap);
  EXPECT_NO_THROW(sign_in(database(), "ada", secret("another long phrase"), cheap));
  ada.sign_out();
  EXPECT_EQ(read_audit(database()).back().entry.action, "signed_out");
}

TEST(OpenHouse, ClosesWithTheFirstPersonWhoIsAnAdministrator) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  auto house = OpenHouse::enter(database);
  ASSERT_TRUE(house);
  EXPECT_EQ(kind_thrown([&] {
              house->add_first_administrator({"ada", "", false}, secret(good_password), cheap);
            }),
            DatabaseErrorKind::BadInput);
  house->add_first_administrator({"ada", "", true}, secret(good_password), cheap);
  EXPECT_FALSE(OpenHouse::enter(database));
  EXPECT_EQ(kind_thrown([&] {
              house->add_first_administrator({"bob", "", true}, secret(good_password), cheap);
            }),
            DatabaseErrorKind::Refused);
}

}  // namespace

}  // namespace hallux::database
