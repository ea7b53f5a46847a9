/// What a person has learned is judged from runs alone: those of the newest rubric, on the device
/// of the last one, each passed or not. A cohort's runs come with the standings, one's own with the
/// attempts; both ways end in one function, so that trainee and instructor see the same word.
#include "ui/jobs/course/standing_jobs.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "database/content/assets.h"

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

/// With the score that stands, and whether it passes; without where it is void, not valid or has
/// none.
JudgedAttempt judged(database::AttemptHeader header) {
  JudgedAttempt attempt;
  const bool counts = header.state != database::AttemptState::Void &&
                      header.is_valid.value_or(true) && header.is_counted;
  if (counts && header.score_milli) {
    attempt.rubric_version = header.rubric_version;
    attempt.score_milli = header.decided_milli.value_or(*header.score_milli);
    attempt.pass = assessment::pass_answer(header.pass, *attempt.score_milli);
  }
  attempt.header = std::move(header);
  return attempt;
}

OwnOperation standing_in(database::Database& database, database::Operation published) {
  OwnOperation own;
  own.published = std::move(published);
  own.learning = learning_in(own.published.standing);
  const database::ScenarioText text =
      database::get_scenario_version(database, own.published.scenario);
  try {
    own.scenario = scenarios::parse_scenario(text.json, text.name);
  } catch (const scenarios::ScenarioError& error) {
    own.fault = error.what();
  }
  return own;
}

/// What a run says about learning.
struct RunAnswer {
  std::string_view device_class;
  std::int32_t rubric_version = 0;
  assessment::PassAnswer pass = assessment::PassAnswer::NotDecided;
};

/// `runs` are oldest first.
assessment::LearningState learning_by(const std::vector<RunAnswer>& runs) {
  std::int32_t newest_rubric = 0;
  for (const RunAnswer& run : runs) newest_rubric = std::max(newest_rubric, run.rubric_version);
  const auto decides = [&](const RunAnswer& run) {
    return run.rubric_version == newest_rubric && run.pass != assessment::PassAnswer::NotDecided;
  };
  const auto last = std::find_if(runs.rbegin(), runs.rend(), decides);
  std::vector<bool> passed;
  for (const RunAnswer& run : runs) {
    if (decides(run) && run.device_class == last->device_class)
      passed.push_back(run.pass == assessment::PassAnswer::Reached);
  }
  return assessment::learning_state(passed);
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
    own.push_back(judged(std::move(header)));
  }
  std::reverse(own.begin(), own.end());
  return own;
}

TraineeProgress progress_in(database::TraineeStanding standing) {
  TraineeProgress progress{std::move(standing), {}};
  for (const database::OperationStanding& operation : progress.standing.operations)
    progress.learning.push_back(learning_in(operation));
  return progress;
}

std::vector<TraineeProgress> trainees_of(database::InstructorDesk& desk) {
  std::vector<TraineeProgress> trainees;
  for (database::TraineeStanding& standing : desk.trainees())
    trainees.push_back(progress_in(std::move(standing)));
  return trainees;
}

std::vector<OwnOperation> own_operations(database::Session& session, database::Database& database) {
  std::vector<OwnOperation> operations;
  for (database::Operation& published : own_desk(session).operations()) {
    operations.push_back(standing_in(database, std::move(published)));
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

assessment::LearningState learning_in(const database::OperationStanding& standing) {
  std::vector<std::pair<std::int64_t, RunAnswer>> begun;
  for (const database::DeviceRuns& device : standing.by_device) {
    for (const database::AssessedRun& run : device.runs) {
      begun.push_back({run.begun_s,
                       {device.device_class, run.rubric_version,
                        assessment::pass_answer(run.pass, run.standing_milli)}});
    }
  }
  std::stable_sort(begun.begin(), begun.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<RunAnswer> runs;
  runs.reserve(begun.size());
  for (const auto& [begun_s, run] : begun) runs.push_back(run);
  return learning_by(runs);
}

assessment::LearningState learning_of(const std::vector<JudgedAttempt>& attempts,
                                      const std::string& scenario_name) {
  std::vector<RunAnswer> runs;
  for (const JudgedAttempt& attempt : attempts) {
    const database::AttemptHeader& header = attempt.header;
    if (header.scenario_name != scenario_name) continue;
    const bool is_assessment = header.begun.kind == database::AttemptKind::Assessment;
    runs.push_back({header.begun.device_class, attempt.rubric_version,
                    is_assessment ? attempt.pass : assessment::PassAnswer::NotDecided});
  }
  return learning_by(runs);
}

}  // namespace hallux::ui
