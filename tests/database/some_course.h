/// A course to test desks in: root and max administer; ada and bob are trainees of autumn, eve of
/// spring; kim teaches autumn; lee teaches spring and is a trainee of autumn.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "database/desks/session.h"
#include "tests/database/some_database.h"

namespace hallux::database {

inline constexpr const char* good_password = "a long enough phrase";

/// Long enough that no random bytes spell it.
inline constexpr const char* long_name = "Bob whom nobody forgets";

class SomeCourse {
 public:
  /// Without names, but for bob where he is given one.
  explicit SomeCourse(const std::string& name_of_bob = "");

  Database& database() noexcept { return database_; }
  CohortId autumn() const noexcept { return autumn_; }
  CohortId spring() const noexcept { return spring_; }
  /// Of the scenario that is published.
  ScenarioVersionId published() const noexcept { return published_; }

  Session sign_in_as(const std::string& login);
  TraineeDesk trainee(const std::string& login);
  InstructorDesk instructor(const std::string& login, CohortId cohort);
  AdministratorDesk administrator();
  PersonId id_of(const std::string& login);

  /// Of the person's own hand, in a published scenario.
  NewAttempt attempt_of(const std::string& login);
  AttemptId recorded_by(const std::string& login);
  AttemptId scored_by(const std::string& login, std::int64_t score_milli);
  AttemptId recorded_by_robot();
  /// Begun by nobody alive: state interrupted.
  AttemptId interrupted_of(const std::string& login);
  AuditEntry last_audit();

 private:
  TemporaryDirectory temporary_;
  Database database_;
  CohortId autumn_, spring_;
  ScenarioVersionId published_;
};

ScoreCard card_worth(std::int64_t score_milli);

template <typename Work>
DatabaseErrorKind kind_thrown(Work&& work) {
  try {
    work();
  } catch (const DatabaseError& error) {
    EXPECT_FALSE(std::string{error.what()}.empty());
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return DatabaseErrorKind::InputOutput;
}

}  // namespace hallux::database
