/// How people stand in the course: the operations that are published with what they are about, the
/// own attempts, and the trainees of a cohort.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/learning.h"
#include "assessment/pass_mark.h"
#include "database/desks/session.h"
#include "scenarios/scenario.h"

namespace hallux::ui {

/// An attempt, and what it says about whoever made it.
struct JudgedAttempt {
  database::AttemptHeader header;
  /// That stands: an instructor's before the machine's; nothing: not scored, not valid, or void.
  std::optional<std::int64_t> score_milli;
  assessment::PassAnswer pass = assessment::PassAnswer::NotDecided;
  /// 0: not scored.
  std::int32_t rubric_version = 0;
};

/// Oldest first.
/// errors  DatabaseError: Refused for a person disabled since; storage failures
std::vector<JudgedAttempt> own_attempts(database::Session& session);

/// A trainee of a cohort, with how they learn.
struct TraineeProgress {
  database::TraineeStanding standing;
  /// As the standing's operations.
  std::vector<assessment::LearningState> learning;
};

TraineeProgress progress_in(database::TraineeStanding standing);

/// By login.
/// errors  DatabaseError: Refused; storage failures
std::vector<TraineeProgress> trainees_of(database::InstructorDesk& desk);

/// A published operation and how the person stands in it.
struct OwnOperation {
  database::Operation published;
  std::optional<scenarios::Scenario> scenario;
  /// Why there is no scenario: its text is of another program's version.
  std::string fault;
  assessment::LearningState learning;

  /// The scenario's title, or the name it is kept under.
  const std::string& title() const noexcept;
};

/// The easiest first.
/// errors  DatabaseError: Refused for a person disabled since; storage failures
std::vector<OwnOperation> own_operations(database::Session& session, database::Database& database);

/// One of them.
/// errors  as above; DatabaseError NotFound where it is not published; ScenarioError where its text
///         cannot be read
OwnOperation own_operation(database::Session& session, database::Database& database,
                           database::ScenarioVersionId scenario);

/// 1 to 5: one for each cut that is to be made. The format says nothing of its own about it yet.
int difficulty_of(const scenarios::Scenario& scenario) noexcept;

/// How somebody learns an operation: by their assessments that pass or do not, see
/// assessment/learning.h. The curve is of the newest rubric that scored any of them: what was
/// declared stands until an attempt is scored by another; and of the device class of the last one:
/// who has learnt it by mouse has not yet by an arm.
/// needs   attempts are oldest first
assessment::LearningState learning_of(const std::vector<JudgedAttempt>& attempts,
                                      const std::string& scenario_name);
/// The same of what is kept of them.
assessment::LearningState learning_in(const database::OperationStanding& standing);

}  // namespace hallux::ui
