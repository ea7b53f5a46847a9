#include "ui/jobs/rescore_jobs.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "database/content/assets.h"
#include "database/course/score_json.h"
#include "simulator/base/progress.h"

namespace hallux::ui {

namespace {

using database::AttemptState;
using database::DatabaseError;
using database::DatabaseErrorKind;

/// An attempt, and the desk from which it is scored.
struct Listed {
  database::AttemptHeader header;
  database::AttemptDesk* desk = nullptr;
};

bool is_wanted(const database::AttemptHeader& header, const std::string& scenario_name) {
  return header.scenario_name == scenario_name && header.state != AttemptState::Void &&
         header.state != AttemptState::Recording;
}

std::vector<Listed> listed_at(std::vector<database::AttemptDesk>& desks,
                              const std::string& scenario_name) {
  std::vector<Listed> listed;
  std::set<std::string> seen;
  for (database::AttemptDesk& desk : desks) {
    for (database::AttemptHeader& header : desk.attempts()) {
      if (!is_wanted(header, scenario_name) || !seen.insert(header.id.text).second) continue;
      if (!desk.may(database::Action::StoreScore, header)) continue;
      listed.push_back({std::move(header), &desk});
    }
  }
  std::sort(listed.begin(), listed.end(),
            [](const Listed& a, const Listed& b) { return a.header.order < b.header.order; });
  return listed;
}

/// One that is known before one that was only operated.
std::optional<database::ScenarioVersionId> find_version(const std::vector<Listed>& listed,
                                                        const Rescoring& rescoring) {
  std::optional<database::ScenarioVersionId> found;
  for (const Listed& each : listed)
    if (each.header.scenario_version == rescoring.version) found = each.header.begun.scenario;
  for (const KnownVersion& known : rescoring.versions)
    if (known.scenario_name == rescoring.scenario_name && known.version == rescoring.version)
      found = known.id;
  return found;
}

std::optional<scenarios::Scenario> scoring_scenario(database::Database& database,
                                                    const std::vector<Listed>& listed,
                                                    const Rescoring& rescoring) {
  if (!rescoring.version) return std::nullopt;
  const auto id = find_version(listed, rescoring);
  if (!id) {
    throw DatabaseError(DatabaseErrorKind::NotFound,
                        "there is no version " + std::to_string(*rescoring.version) + " of '" +
                            rescoring.scenario_name + "' in " + database.file().string());
  }
  const database::ScenarioText text = database::get_scenario_version(database, *id);
  return scenarios::parse_scenario(text.json, text.name);
}

/// Whether the others can be scored though this one could not.
bool is_of_one_attempt(const DatabaseError& error) noexcept {
  return error.kind() == DatabaseErrorKind::NotFound || error.kind() == DatabaseErrorKind::Damaged;
}

/// Scores one attempt after the other: from what was measured of it before where that is kept, else
/// from its recording.
class Rescorer {
 public:
  /// scenario  whose text scores; nothing: that of each attempt
  Rescorer(database::Database& database, std::optional<scenarios::Scenario> scenario, bool is_dry)
      : database_(database), scenario_(std::move(scenario)), is_dry_(is_dry) {}

  /// The card after, and the measurements kept unless it is a dry run.
  database::ScoreCard score(const Listed& listed, const StageProgress& progress) {
    const database::AttemptHeader& header = listed.header;
    const scenarios::Scenario& scenario = scenario_ ? *scenario_ : text_of(header);
    if (const auto kept = listed.desk->measurements(header.id, by(scenario, header))) {
      return assessment::score_measurements(scenario, *kept, header.begun.device_class,
                                            header.begun.engine);
    }
    AttemptMaterial material = load_to_score(database_, *listed.desk, header.id);
    material.scenario = scenario;
    assessment::Examination examination = score_attempt(material, progress);
    if (!is_dry_)
      listed.desk->store_measurements(header.id, by(scenario, header), examination.measurements);
    return std::move(examination.card);
  }

 private:
  /// Of another version one text, of their own the attempts of one version one.
  const scenarios::Scenario& text_of(const database::AttemptHeader& header) {
    const database::ScenarioVersionId version = header.begun.scenario;
    const auto known = texts_.find(version.number);
    if (known != texts_.end()) return known->second;
    const database::ScenarioText text = database::get_scenario_version(database_, version);
    return texts_.emplace(version.number, scenarios::parse_scenario(text.json, text.name))
        .first->second;
  }
  /// Attempts of one text on one bone have the same.
  const database::MeasuredBy& by(const scenarios::Scenario& scenario,
                                 const database::AttemptHeader& header) {
    const auto known = std::ranges::find_if(plans_, [&](const KnownPlan& plan) {
      return plan.scenario == &scenario && plan.bone == header.begun.bone;
    });
    if (known != plans_.end()) return known->by;
    return plans_
        .emplace_back(
            KnownPlan{&scenario, header.begun.bone, measured_by(scenario, header.begun.bone)})
        .by;
  }

  database::Database& database_;
  std::optional<scenarios::Scenario> scenario_;
  bool is_dry_;
  struct KnownPlan {
    const scenarios::Scenario* scenario = nullptr;
    Digest bone;
    database::MeasuredBy by;
  };
  /// By the version's number.
  std::map<std::int64_t, scenarios::Scenario> texts_;
  std::deque<KnownPlan> plans_;
};

RescoredAttempt rescored(Rescorer& rescorer, const Listed& listed, const StageProgress& progress) {
  RescoredAttempt attempt;
  attempt.header = listed.header;
  try {
    if (auto score = listed.desk->score(listed.header.id)) attempt.before = std::move(score->card);
    attempt.after = rescorer.score(listed, progress);
  } catch (const DatabaseError& error) {
    if (!is_of_one_attempt(error)) throw;
    attempt.fault = error.what();
    return attempt;
  } catch (const scenarios::ScenarioError& error) {
    attempt.fault = error.what();
    return attempt;
  }
  attempt.is_changed = !attempt.before || !database::is_same_score(*attempt.before, *attempt.after);
  return attempt;
}

/// So many scores are stored together: a write to the disk takes longer than a score.
constexpr std::size_t stored_together = 64;

/// The attempts that were scored, the newest of them not stored yet.
class Rescored {
 public:
  explicit Rescored(bool is_dry) : is_dry_(is_dry) {}

  void add(RescoredAttempt attempt, database::AttemptDesk& desk) {
    if (desk_ != &desk || attempts_.size() - first_unstored_ >= stored_together) store();
    desk_ = &desk;
    attempts_.push_back(std::move(attempt));
  }
  /// Those that changed since the last time.
  void store() {
    if (is_dry_ || desk_ == nullptr) return;
    std::vector<database::NewScore> scores;
    for (std::size_t i = first_unstored_; i < attempts_.size(); ++i) {
      RescoredAttempt& each = attempts_[i];
      if (each.is_changed) scores.push_back({each.header.id, *each.after});
    }
    if (!scores.empty()) store_all_or_each(scores);
    for (; first_unstored_ < attempts_.size(); ++first_unstored_) {
      RescoredAttempt& each = attempts_[first_unstored_];
      each.is_stored = each.is_changed && each.fault.empty();
      stored_ += each.is_stored ? 1 : 0;
    }
  }
  [[noreturn]] void stop(std::size_t all) {
    store();
    throw Cancelled("the scoring was stopped after " + std::to_string(attempts_.size()) + " of " +
                    std::to_string(all) + " attempts; " + std::to_string(stored_) +
                    " new scores were stored and stay beside the old ones");
  }
  std::size_t size() const noexcept { return attempts_.size(); }
  std::vector<RescoredAttempt> take() && {
    store();
    return std::move(attempts_);
  }

 private:
  /// What may not be stored any more is told of that attempt alone.
  void store_all_or_each(std::span<const database::NewScore> scores) {
    try {
      desk_->store_scores(scores);
    } catch (const DatabaseError& error) {
      if (error.kind() != DatabaseErrorKind::Refused && !is_of_one_attempt(error)) throw;
      for (const database::NewScore& score : scores) store_one(score);
    }
  }
  void store_one(const database::NewScore& score) {
    try {
      desk_->store_score(score.attempt, score.card);
    } catch (const DatabaseError& error) {
      if (error.kind() != DatabaseErrorKind::Refused && !is_of_one_attempt(error)) throw;
      for (std::size_t i = first_unstored_; i < attempts_.size(); ++i)
        if (attempts_[i].header.id == score.attempt) attempts_[i].fault = error.what();
    }
  }

  bool is_dry_;
  std::vector<RescoredAttempt> attempts_;
  std::size_t first_unstored_ = 0;
  long stored_ = 0;
  /// Of those that are not stored.
  database::AttemptDesk* desk_ = nullptr;
};

}  // namespace

std::vector<RescoredAttempt> rescore(database::Database& database,
                                     std::vector<database::AttemptDesk>& desks,
                                     const Rescoring& rescoring, const Progress& progress) {
  const std::vector<Listed> listed = listed_at(desks, rescoring.scenario_name);
  if (listed.empty()) {
    throw DatabaseError(DatabaseErrorKind::NotFound,
                        "there is no attempt of '" + rescoring.scenario_name +
                            "' that could be scored from here; `hallux attempts` lists those "
                            "there are");
  }
  Rescorer rescorer(database, scoring_scenario(database, listed, rescoring), rescoring.is_dry_run);
  Rescored attempts(rescoring.is_dry_run);
  for (const Listed& each : listed) {
    const double done = static_cast<double>(attempts.size()) / static_cast<double>(listed.size());
    if (progress && !progress(done)) attempts.stop(listed.size());
    const StageProgress stage = [&](const std::string&) { return part_of(progress, done, done); };
    try {
      attempts.add(rescored(rescorer, each, stage), *each.desk);
    } catch (const Cancelled&) {
      attempts.stop(listed.size());
    } catch (...) {
      attempts.store();
      throw;
    }
  }
  if (progress) progress(1.0);
  return std::move(attempts).take();
}

}  // namespace hallux::ui
