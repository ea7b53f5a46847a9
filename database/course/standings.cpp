/// Runs are kept in the row of a standing as one text, which the schema's triggers write: a cohort
/// of a thousand is one pass along two keys, without sorting and without a row for each run. A
/// check counts them person by person from nothing and wants the same rows.
#include "database/course/standings.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

#include "database/people/cohorts.h"
#include "database/recording/attempts.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr const char* standing_columns_of =
    "SELECT t.person_id, t.scenario_name, t.device_class, t.attempts, t.assessments, t.best_milli, "
    "t.last_milli, t.last_scored_utc, t.last_started_utc, t.runs ";

/// The next whole number of a row of them; 0 where there is none. Moves past it and the sign behind
/// it.
std::int64_t number_at(std::string_view& text) noexcept {
  std::int64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  if (!text.empty()) text.remove_prefix(1);
  return number;
}

/// As the view standing_as_counted writes them.
std::vector<AssessedRun> runs_in(std::string_view text) {
  std::vector<AssessedRun> runs;
  runs.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), ' ')) + 1);
  while (!text.empty()) {
    AssessedRun& run = runs.emplace_back();
    run.begun_s = number_at(text);
    run.rubric_version = static_cast<std::int32_t>(number_at(text));
    run.standing_milli = number_at(text);
    run.pass.measured_milli = number_at(text);
    run.pass.rubric_milli = number_at(text);
    run.pass.is_gated = number_at(text) != 0;
    run.pass.safety_measured_milli = number_at(text);
    run.pass.safety_earned_milli = number_at(text);
  }
  return runs;
}

/// Gathers the rows of one person by operation.
class Gathering {
 public:
  explicit Gathering(std::vector<OperationStanding>& operations) : operations_(operations) {}

  /// needs   the rows come by name of the operation
  void add(SQLite::Statement& row) {
    OperationStanding& standing = operation(row.getColumn(1).getString());
    standing.attempts += row.getColumn(3).getInt();
    standing.assessments += row.getColumn(4).getInt();
    if (!row.getColumn(5).isNull()) {
      const std::int64_t best = row.getColumn(5).getInt64();
      standing.best_milli = std::max(standing.best_milli.value_or(best), best);
    }
    if (!row.getColumn(6).isNull() && row.getColumn(7).getString() >= last_scored_utc_) {
      last_scored_utc_ = row.getColumn(7).getString();
      standing.last_milli = row.getColumn(6).getInt64();
    }
    standing.last_started_utc = std::max(standing.last_started_utc, row.getColumn(8).getString());
    const SQLite::Column runs = row.getColumn(9);
    if (runs.getBytes() == 0) return;
    standing.by_device.push_back(
        {row.getColumn(2).getString(),
         runs_in({runs.getText(), static_cast<std::size_t>(runs.getBytes())})});
  }

 private:
  OperationStanding& operation(std::string name) {
    if (operations_.empty() || operations_.back().scenario_name != name) {
      operations_.emplace_back().scenario_name = std::move(name);
      last_scored_utc_.clear();
    }
    return operations_.back();
  }

  std::vector<OperationStanding>& operations_;
  std::string last_scored_utc_;
};

/// Of each trainee in the list, by their number.
using TraineeIndices = std::map<std::int64_t, std::size_t>;

void add_operations(Database& database, CohortId cohort, const TraineeIndices& indices,
                    std::vector<TraineeStanding>& standings) {
  // Person by person along both keys, so that nothing is sorted: the runs of a thousand people are
  // two megabytes.
  auto rows = prepared(database,
                       std::string{standing_columns_of} +
                           "FROM membership m CROSS JOIN standing t ON t.person_id = m.person_id "
                           "WHERE m.cohort_id = ? AND +m.role = 'trainee' "
                           "ORDER BY m.person_id, t.scenario_name, t.device_class",
                       cohort.number);
  std::optional<Gathering> gathering;
  std::int64_t person = 0;
  while (rows.executeStep()) {
    if (!gathering || rows.getColumn(0).getInt64() != person) {
      person = rows.getColumn(0).getInt64();
      const auto index = indices.find(person);
      if (index == indices.end()) continue;  // enrolled in between
      gathering.emplace(standings[index->second].operations);
    }
    gathering->add(rows);
  }
}

void add_open_requests(Database& database, CohortId cohort, const TraineeIndices& indices,
                       std::vector<TraineeStanding>& standings) {
  auto rows = prepared(database,
                       "SELECT h.asker_person_id, count(*) FROM help_request h JOIN membership m "
                       "ON m.person_id = h.asker_person_id WHERE m.cohort_id = ? "
                       "AND h.answered_utc IS NULL GROUP BY h.asker_person_id",
                       cohort.number);
  while (rows.executeStep()) {
    const auto index = indices.find(rows.getColumn(0).getInt64());
    if (index != indices.end())
      standings[index->second].open_help_requests = rows.getColumn(1).getInt();
  }
}

void add_last_attempts(Database& database, std::int32_t attempts_max, TraineeStanding& standing) {
  if (attempts_max <= 0) return;
  AttemptFilter newest;
  newest.person = standing.id;
  newest.count_max = attempts_max;
  standing.last_attempts = list_attempts(database, newest);
}

TraineeStanding standing_of(const CohortMember& member) {
  TraineeStanding standing;
  standing.id = member.id;
  standing.login = member.login;
  standing.display_name = member.display_name;
  standing.is_disabled = member.is_disabled;
  return standing;
}

[[noreturn]] void fail_differs(const Database& database, const std::string& row) {
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      row + " in " + database.file().string() +
                          " was altered: it is not what the attempts say; restore a backup"};
}

void check_standings_of(Database& database, std::int64_t person) {
  constexpr const char* columns =
      "SELECT person_id, scenario_name, device_class, attempts, assessments, best_milli, "
      "last_milli, last_scored_utc, last_started_utc, confirmed_milli, runs FROM ";
  const std::string kept = std::string{columns} + "standing WHERE person_id = ?1";
  const std::string counted = std::string{columns} + "standing_as_counted WHERE person_id = ?1";
  const auto differing = found<std::string>(
      database,
      "SELECT scenario_name FROM (SELECT * FROM (" + kept + " EXCEPT " + counted +
          ") UNION ALL SELECT * FROM (" + counted + " EXCEPT " + kept + ")) LIMIT 1",
      person);
  if (!differing) return;
  fail_differs(database, "how person " + std::to_string(person) + " stands in " + *differing);
}

}  // namespace

std::vector<OperationStanding> operation_standings(Database& database, PersonId person) {
  return translating(database, "gather how a person stands", [&] {
    auto rows = prepared(
        database,
        std::string{standing_columns_of} +
            "FROM standing t WHERE t.person_id = ? ORDER BY t.scenario_name, t.device_class",
        person.number);
    std::vector<OperationStanding> operations;
    Gathering gathering{operations};
    while (rows.executeStep()) gathering.add(rows);
    return operations;
  });
}

std::vector<TraineeStanding> list_standings(Database& database, CohortId cohort,
                                            std::int32_t attempts_max) {
  std::vector<TraineeStanding> standings;
  TraineeIndices indices;
  for (const CohortMember& member : list_members(database, cohort)) {
    if (member.role != CohortRole::Trainee) continue;
    indices.emplace(member.id.number, standings.size());
    standings.push_back(standing_of(member));
    add_last_attempts(database, attempts_max, standings.back());
  }
  translating(database, "gather how a cohort stands", [&] {
    add_operations(database, cohort, indices, standings);
    add_open_requests(database, cohort, indices, standings);
  });
  return standings;
}

TraineeStanding load_standing(Database& database, CohortId cohort, PersonId trainee,
                              std::int32_t attempts_max) {
  for (const CohortMember& member : list_members(database, cohort)) {
    if (member.id != trainee || member.role != CohortRole::Trainee) continue;
    std::vector<TraineeStanding> one{standing_of(member)};
    add_last_attempts(database, attempts_max, one.front());
    one.front().operations = operation_standings(database, trainee);
    translating(database, "count the open questions", [&] {
      add_open_requests(database, cohort, {{trainee.number, 0}}, one);
    });
    return std::move(one.front());
  }
  throw DatabaseError{DatabaseErrorKind::NotFound,
                      "person " + std::to_string(trainee.number) + " is no trainee of cohort " +
                          std::to_string(cohort.number) + " in " + database.file().string()};
}

void recount_standings(Database& database) {
  in_transaction_of_caller(database, "count how people stand", [&] {
    database.connection().exec(
        "DELETE FROM standing; "
        "INSERT INTO standing SELECT person_id, scenario_name, device_class, attempts, "
        "assessments, best_milli, last_milli, last_scored_utc, last_started_utc, confirmed_milli, "
        "runs FROM standing_as_counted");
  });
}

void check_standings(Database& database) {
  translating(database, "check how people stand", [&] {
    // One person at a time: no long reading, whose memory would grow with the course.
    for (const std::int64_t person : all_of<std::int64_t>(database, "SELECT person_id FROM person"))
      check_standings_of(database, person);
  });
}

}  // namespace hallux::database
