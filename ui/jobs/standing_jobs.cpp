#include "ui/jobs/standing_jobs.h"

#include <algorithm>

#include "database/assets.h"

namespace hallux::ui {

namespace {

database::TraineeDesk own_desk(database::Session& session) {
  std::optional<database::TraineeDesk> desk = session.trainee();
  if (!desk) {
    throw database::DatabaseError(database::DatabaseErrorKind::Refused,
                                  "you were disabled in this course; ask its administrator");
  }
  return *desk;
}

/// With the score that stands, and whether it passes; without where it is void or has none.
JudgedAttempt judged(database::CourseDesk& desk, database::AttemptHeader header) {
  JudgedAttempt attempt;
  attempt.header = std::move(header);
  const bool counts = attempt.header.state != database::AttemptState::Void;
  if (!counts || !attempt.header.score_milli) return attempt;
  if (const auto score = desk.score(attempt.header.id)) {
    attempt.rubric_version = score->card.rubric_version;
    attempt.score_milli = attempt.header.decided_milli.value_or(score->card.score_milli);
    attempt.pass = assessment::pass_answer(score->card, *attempt.score_milli);
  }
  return attempt;
}

OwnOperation standing_in(database::Database& database, database::Operation published,
                         const std::vector<JudgedAttempt>& attempts) {
  OwnOperation own;
  own.published = std::move(published);
  own.learning = learning_of(attempts, own.published.name);
  const database::ScenarioText text =
      database::get_scenario_version(database, own.published.scenario);
  try {
    own.scenario = scenarios::parse_scenario(text.json, text.name);
  } catch (const scenarios::ScenarioError& error) {
    own.fault = error.what();
  }
  return own;
}

/// What cannot be read comes last.
int rank_of(const OwnOperation& operation) noexcept {
  return operation.scenario ? difficulty_of(*operation.scenario) : 6;
}

}  // namespace

const std::string& OwnOperation::title() const noexcept {
  return scenario ? scenario->title : published.name;
}

std::vector<JudgedAttempt> own_attempts(database::Session& session) {
  database::TraineeDesk desk = own_desk(session);
  std::vector<JudgedAttempt> own;
  for (database::AttemptHeader& header : desk.attempts()) {
    if (header.begun.person != session.person().id) continue;  // the robot's
    own.push_back(judged(desk, std::move(header)));
  }
  std::reverse(own.begin(), own.end());
  return own;
}

TraineeProgress trainee_progress(database::InstructorDesk& desk,
                                 database::TraineeStanding standing) {
  std::vector<JudgedAttempt> attempts;
  for (database::AttemptHeader& header : desk.attempts_of(standing.id)) {
    // Practice says nothing about competence, and there is much of it.
    if (header.begun.kind == database::AttemptKind::Assessment)
      attempts.push_back(judged(desk, std::move(header)));
  }
  std::reverse(attempts.begin(), attempts.end());
  TraineeProgress progress{std::move(standing), {}};
  for (const database::OperationStanding& operation : progress.standing.operations)
    progress.learning.push_back(learning_of(attempts, operation.scenario_name));
  return progress;
}

std::vector<TraineeProgress> trainees_of(database::InstructorDesk& desk,
                                         std::int32_t attempts_max) {
  std::vector<TraineeProgress> trainees;
  for (database::TraineeStanding& standing : desk.trainees(attempts_max))
    trainees.push_back(trainee_progress(desk, std::move(standing)));
  return trainees;
}

std::vector<OwnOperation> own_operations(database::Session& session, database::Database& database) {
  const std::vector<JudgedAttempt> attempts = own_attempts(session);
  std::vector<OwnOperation> operations;
  for (database::Operation& published : own_desk(session).operations()) {
    operations.push_back(standing_in(database, std::move(published), attempts));
  }
  std::stable_sort(
      operations.begin(), operations.end(),
      [](const OwnOperation& a, const OwnOperation& b) { return rank_of(a) < rank_of(b); });
  return operations;
}

OwnOperation own_operation(database::Session& session, database::Database& database,
                           database::ScenarioVersionId scenario) {
  for (OwnOperation& operation : own_operations(session, database)) {
    if (operation.published.scenario != scenario) continue;
    if (!operation.scenario) throw scenarios::ScenarioError(operation.fault);
    return std::move(operation);
  }
  throw database::DatabaseError(database::DatabaseErrorKind::NotFound,
                                "this version of the operation is no longer published");
}

int difficulty_of(const scenarios::Scenario& scenario) noexcept {
  return std::clamp(static_cast<int>(scenario.cuts.size()), 1, 5);
}

assessment::LearningState learning_of(const std::vector<JudgedAttempt>& attempts,
                                      const std::string& scenario_name) {
  std::int32_t newest_rubric = 0;
  for (const JudgedAttempt& attempt : attempts) {
    if (attempt.header.scenario_name == scenario_name)
      newest_rubric = std::max(newest_rubric, attempt.rubric_version);
  }
  std::vector<const JudgedAttempt*> judged;
  for (const JudgedAttempt& attempt : attempts) {
    const database::AttemptHeader& header = attempt.header;
    if (header.scenario_name == scenario_name && attempt.rubric_version == newest_rubric &&
        header.begun.kind == database::AttemptKind::Assessment &&
        attempt.pass != assessment::PassAnswer::NotDecided) {
      judged.push_back(&attempt);
    }
  }
  std::vector<bool> passed;
  for (const JudgedAttempt* attempt : judged) {
    if (attempt->header.begun.device_class == judged.back()->header.begun.device_class)
      passed.push_back(attempt->pass == assessment::PassAnswer::Reached);
  }
  return assessment::learning_state(passed);
}

}  // namespace hallux::ui
