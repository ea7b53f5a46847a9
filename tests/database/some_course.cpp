#include "tests/database/some_course.h"

#include "database/audit/audit.h"
#include "database/course/begin_attempt.h"

namespace hallux::database {

SomeCourse::SomeCourse(const std::string& name_of_bob)
    : database_(Database::open(temporary_.data())) {
  OpenHouse::enter(database_)->add_first_administrator({"root", "", true}, secret(good_password),
                                                       cheap);
  AdministratorDesk desk = administrator();
  for (const char* login : {"ada", "bob", "eve", "kim", "lee"}) {
    const bool is_bob = std::string_view{login} == "bob";
    desk.add_person({login, is_bob ? name_of_bob : "", false}, secret(good_password), cheap);
  }
  desk.add_person({"max", "", true}, secret(good_password), cheap);
  autumn_ = desk.add_cohort("autumn");
  spring_ = desk.add_cohort("spring");
  desk.enrol(autumn_, "ada", CohortRole::Trainee);
  desk.enrol(autumn_, "bob", CohortRole::Trainee);
  desk.enrol(autumn_, "kim", CohortRole::Instructor);
  desk.enrol(autumn_, "lee", CohortRole::Trainee);
  desk.enrol(spring_, "eve", CohortRole::Trainee);
  desk.enrol(spring_, "lee", CohortRole::Instructor);
  published_ = desk.import_scenario({"silver", 1, "{\"name\": \"silver\"}", false});
  desk.publish_scenario(published_);
}

Session SomeCourse::sign_in_as(const std::string& login) {
  return sign_in(database_, login, secret(good_password), cheap);
}

TraineeDesk SomeCourse::trainee(const std::string& login) { return *sign_in_as(login).trainee(); }

InstructorDesk SomeCourse::instructor(const std::string& login, CohortId cohort) {
  return *sign_in_as(login).instructor_of(cohort);
}

AdministratorDesk SomeCourse::administrator() { return *sign_in_as("root").administrator(); }

PersonId SomeCourse::id_of(const std::string& login) { return find_person(database_, login).id; }

NewAttempt SomeCourse::attempt_of(const std::string& login) {
  NewAttempt attempt = some_attempt(database_);
  attempt.scenario = published_;
  attempt.person = id_of(login);
  attempt.hand = "";
  return attempt;
}

AttemptId SomeCourse::recorded_by(const std::string& login) {
  return record(database_, attempt_of(login), some_recording(5));
}

AttemptId SomeCourse::scored_by(const std::string& login, std::int64_t score_milli) {
  AttemptId id = recorded_by(login);
  store_score(database_, id, card_worth(score_milli), id_of(login));
  return id;
}

AttemptId SomeCourse::recorded_by_robot() {
  return record(database_, some_attempt(database_), some_recording(5));
}

AttemptId SomeCourse::interrupted_of(const std::string& login) {
  AttemptId id = create_attempt(database_, attempt_of(login)).attempt();
  Database::open(temporary_.data());
  return id;
}

AuditEntry SomeCourse::last_audit() { return read_audit(database_).back().entry; }

ScoreCard card_worth(std::int64_t score_milli) {
  ScoreCard card;
  card.score_milli = score_milli;
  return card;
}

}  // namespace hallux::database
