/// The people of the simulated course and what they do at their desks, at a time that is told
/// beforehand. Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "database/desks/session.h"
#include "database/recording/recorder.h"
#include "ui/jobs/demo/demo_attempts.h"
#include "ui/jobs/demo/demo_course.h"

namespace hallux::ui {

class DemoPeople {
 public:
  /// needs   `database` is empty; it is marked as simulated here
  DemoPeople(database::Database& database, const DemoOptions& options);

  /// Adds everybody, their cohorts, and the catalogue with `operated` published.
  void found(const std::vector<DemoOperation>& operated);
  /// Stores the attempt as its trainee's, with its score, and lets people talk about it.
  void add(const OperatedAttempt& operated);

  DemoCourse take() { return std::move(course_); }

 private:
  struct Kept {
    database::AttemptId id;
    std::int64_t minute = 0;
    int trainee = 1;
    /// About the costliest loss.
    std::string remark;
    database::AttemptMoment moment;
    std::int64_t score_milli = 0;
  };

  void set_time(std::int64_t minute);
  /// Of everybody; with `mistyped` behind it nobody's.
  database::SecretText password(const char* mistyped = "") const;
  database::Session sign_in(const std::string& login);
  void acknowledge_all(const std::string& login);
  database::InstructorDesk desk_of_instructor(int trainee);
  void add_people(database::AdministratorDesk& desk);
  void add_cohorts(database::AdministratorDesk& desk);
  void add_catalogue(database::AdministratorDesk& desk, const std::vector<DemoOperation>& operated);
  Kept keep(const OperatedAttempt& operated);
  void talk(const Kept& kept);
  void mistype_password(int trainee);
  void ask(const Kept& kept);
  void decide(const Kept& kept);

  database::Database& database_;
  database::PasswordCost cost_;
  DemoCourse course_;
  /// Now, since the course began; never goes back.
  std::int64_t minute_ = 0;
  /// When the course began, seconds since 1970.
  std::int64_t begun_s_ = 0;
  std::vector<database::ScenarioVersionId> versions_;
  /// What attempts at each operation have in common.
  std::vector<database::NewAttempt> begun_;
  std::vector<database::MeasuredBy> measured_by_;
  database::CohortId cohort_a_, cohort_b_;
};

}  // namespace hallux::ui
