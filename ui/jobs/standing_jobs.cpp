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
  return *std::move(desk);
}

/// The score that stands, and whether it passes.
void judge(OwnAttempt& attempt, const database::ScoreCard& card) {
  attempt.rubric_version = card.rubric_version;
  attempt.score_milli = attempt.header.decided_milli.value_or(card.score_milli);
  attempt.pass = assessment::pass_answer(card, *attempt.score_milli);
}

OwnOperation standing_in(database::Database& database, database::Operation published,
                         const std::vector<OwnAttempt>& attempts) {
  OwnOperation own;
  own.published = std::move(published);
  const database::ScenarioText text =
      database::get_scenario_version(database, own.published.scenario);
  try {
    own.scenario = scenarios::parse_scenario(text.json, text.name);
    own.learning = learning_of(attempts, own.published.name, own.scenario->rubric.version);
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

std::vector<OwnAttempt> own_attempts(database::Session& session) {
  database::TraineeDesk desk = own_desk(session);
  std::vector<OwnAttempt> own;
  for (database::AttemptHeader& header : desk.attempts()) {
    if (header.begun.person != session.person().id) continue;  // the robot's
    OwnAttempt& attempt = own.emplace_back();
    attempt.header = std::move(header);
    const bool counts = attempt.header.state != database::AttemptState::Void;
    if (!counts || !attempt.header.score_milli) continue;
    if (const auto score = desk.score(attempt.header.id)) judge(attempt, score->card);
  }
  std::reverse(own.begin(), own.end());
  return own;
}

std::vector<OwnOperation> own_operations(database::Session& session, database::Database& database) {
  const std::vector<OwnAttempt> attempts = own_attempts(session);
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

assessment::LearningState learning_of(const std::vector<OwnAttempt>& attempts,
                                      const std::string& scenario_name,
                                      std::int32_t rubric_version) {
  std::vector<bool> passed;
  for (const OwnAttempt& attempt : attempts) {
    const database::AttemptHeader& header = attempt.header;
    if (header.scenario_name == scenario_name && attempt.rubric_version == rubric_version &&
        header.begun.kind == database::AttemptKind::Assessment &&
        attempt.pass != assessment::PassAnswer::NotDecided) {
      passed.push_back(attempt.pass == assessment::PassAnswer::Reached);
    }
  }
  return assessment::learning_state(passed);
}

}  // namespace hallux::ui
