/// One SELECT reads a header everywhere: facts of the attempt, its scenario, the score and the
/// decision in force, the score that stands (the one that was signed, if any was), and its origin,
/// in the order of the fields. Lists of many attempts are walked
/// from the newest on instead of being gathered and sorted; of few that would be the longer way.
#include "database/recording/attempts.h"

#include "database/audit/audit.h"
#include "database/recording/attempt_numbers.h"
#include "database/recording/certificate_json.h"
#include "database/recording/chain.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr std::string_view header_columns =
    "SELECT a.uuid, a.scenario_version_id, a.person_id, a.hand, a.seed, a.device_class, a.pacing, "
    "a.stereo_mode, a.bone_digest, a.engine_version, a.kind, a.guidance, a.started_utc, a.state, "
    "a.duration_ticks, a.quality_json, a.seal, v.name, v.version, v.digest, d.login, "
    "f.score_milli, a.is_simulated, "
    "CASE WHEN json_valid(a.quality_json) THEN json_extract(a.quality_json, '$.complete') END, "
    "a.attempt_id, s.measured_weight_milli < 100000, a.is_valid, r.kind, r.score_milli, "
    "r.score_id = f.score_id, o.directory_uuid, o.is_accepted, s.rubric_version, "
    "s.measured_weight_milli, s.rubric_milli, s.safety_measured_milli, s.safety_earned_milli, "
    "s.is_gated "
    "FROM attempt a JOIN scenario_version v USING (scenario_version_id) "
    "LEFT JOIN person_detail d ON d.person_id = a.person_id "
    "LEFT JOIN origin o ON o.origin_id = a.origin_id "
    "LEFT JOIN decision r ON r.attempt_id = a.attempt_id AND r.superseded_by IS NULL "
    "LEFT JOIN score f ON f.attempt_id = a.attempt_id AND f.superseded_by IS NULL "
    "LEFT JOIN score s ON s.score_id = coalesce(r.score_id, f.score_id) ";

constexpr std::string_view is_of_cohort =
    " IN (SELECT person_id FROM membership WHERE cohort_id = ?2 AND role = 'trainee')";

std::vector<AttemptHeader> numbered(Database& database, std::vector<AttemptHeader> headers) {
  AttemptNumbers numbers{database};
  for (AttemptHeader& header : headers) {
    header.number = numbers.number_of({header.begun.person, header.scenario_name, header.order});
  }
  return headers;
}

AttemptHeader header_in(SQLite::Statement& row) {
  AttemptHeader header;
  header.state = AttemptState::Interrupted;  // Under a name that is unknown nothing counts.
  NewAttempt& begun = header.begun;
  read_columns(row, 0, header.id, begun.scenario, begun.person, begun.hand, begun.seed,
               begun.device_class, begun.pacing, begun.stereo_mode, begun.bone, begun.engine,
               begun.kind, begun.guidance, header.started_utc, header.state, header.duration_ticks,
               header.quality_json, header.seal, header.scenario_name, header.scenario_version,
               header.scenario_digest, header.login, header.score_milli, header.is_simulated,
               header.is_complete, header.order, header.is_partial, header.is_valid,
               header.decision, header.decided_milli, header.decision_is_of_score_in_force,
               header.origin);
  if (header.origin) read_columns(row, 31, header.is_counted);
  if (header.score_milli) {
    PassFacts& pass = header.pass;
    read_columns(row, 32, header.rubric_version, pass.measured_milli, pass.rubric_milli,
                 pass.safety_measured_milli, pass.safety_earned_milli, pass.is_gated);
  }
  return header;
}

bool is_uuid_start(const std::string& text) noexcept {
  return text.size() >= 4 && text.size() <= 36 &&
         text.find_first_not_of("0123456789abcdef-") == std::string::npos;
}

/// So many attempts are gathered and sorted in a few milliseconds.
constexpr std::int64_t gathered_most = 4000;

struct CohortAttempts {
  std::int64_t count = 0;
  std::string last_started_utc;
};

[[noreturn]] void fail_not_recorded(const Database& database, const char* what,
                                    const AttemptId& id) {
  throw DatabaseError{DatabaseErrorKind::NotFound, std::string{"could not "} + what + " attempt " +
                                                       id.text + " in " + database.file().string() +
                                                       ": it is not being recorded any more"};
}

CohortAttempts attempts_in(Database& database, CohortId cohort) {
  return translating(database, "count the attempts of a cohort", [&] {
    auto row =
        prepared(database,
                 "SELECT coalesce(sum(t.attempts), 0), coalesce(max(t.last_started_utc), '') "
                 "FROM membership m JOIN standing t USING (person_id) WHERE m.cohort_id = ? "
                 "AND m.role = 'trainee'",
                 cohort.number);
    return rows_of(std::move(row), &CohortAttempts::count, &CohortAttempts::last_started_utc).at(0);
  });
}

}  // namespace

std::vector<AttemptHeader> list_attempts(Database& database, const AttemptFilter& filter) {
  std::string where;
  const auto either = [&where](std::string_view condition) {
    where += (where.empty() ? "WHERE " : " OR ") + std::string{condition};
  };
  const CohortAttempts all =
      filter.cohort ? attempts_in(database, *filter.cohort) : CohortAttempts{};
  // The newest few of many are looked for from the newest on, instead of all being gathered and
  // sorted: the sign keeps SQLite from its index of persons. Of few, or of a cohort that ended long
  // ago, that would be the longer way.
  const bool is_walked = filter.count_max && all.count > gathered_most;
  const std::string owner = is_walked ? "+a.person_id" : "a.person_id";
  if (filter.person) either(owner + " = ?1");
  if (filter.cohort) either(owner + std::string{is_of_cohort});
  if (filter.of_nobody) either(owner + " IS NULL");
  const bool is_bounded = is_walked && !filter.of_nobody && !filter.person;
  if (is_bounded) where += " AND a.started_utc <= ?4";
  return translating(database, "list the attempts", [&] {
    SQLite::Statement rows{database.connection(),
                           std::string{header_columns} + where +
                               " ORDER BY a.started_utc DESC, a.attempt_id DESC" +
                               (filter.count_max ? " LIMIT ?3" : "")};
    if (filter.person) rows.bind(1, filter.person->number);
    if (filter.cohort) rows.bind(2, filter.cohort->number);
    if (filter.count_max) rows.bind(3, *filter.count_max);
    if (is_bounded) rows.bind(4, all.last_started_utc);
    return numbered(database, collected(rows, header_in));
  });
}

std::vector<AttemptHeader> headers_that_begin_with(Database& database, const AttemptId& id) {
  return translating(database, "look for an attempt", [&] {
    if (!is_uuid_start(id.text)) return std::vector<AttemptHeader>{};
    auto rows = prepared(database,
                         std::string{header_columns} + "WHERE a.uuid >= ?1 AND a.uuid < ?1 || 'g'",
                         id.text);
    return numbered(database, collected(rows, header_in));
  });
}

AttemptHeader the_one_of(Database& database, std::vector<AttemptHeader> found,
                         const AttemptId& id) {
  if (found.size() == 1) return std::move(found.front());
  throw DatabaseError{
      DatabaseErrorKind::NotFound,
      (found.empty() ? "there is no attempt '" : "more than one attempt begins with '") + id.text +
          "' in " + database.file().string() + "; `hallux attempts` lists those there are"};
}

AttemptHeader load_header(Database& database, const AttemptId& id) {
  return the_one_of(database, headers_that_begin_with(database, id), id);
}

void seal_attempt(Database& database, const AttemptId& id, std::int64_t duration_ticks,
                  const std::string& quality_json, const Digest& last_link) {
  in_transaction(database, "seal attempt " + id.text, [&] {
    AttemptHeader header = load_header(database, id);
    header.duration_ticks = duration_ticks;
    header.quality_json = quality_json;
    const Digest seal = seal_of(last_link, header);
    if (execute(database,
                "UPDATE attempt SET state = 'closed', duration_ticks = ?, "
                "quality_json = ?, seal = ?, is_valid = ? "
                "WHERE uuid = ? AND state = 'recording'",
                duration_ticks, quality_json, seal, is_valid_by(quality_json) ? 1 : 0,
                header.id.text) != 1) {
      fail_not_recorded(database, "seal", id);
    }
    append_audit(database, {header.begun.person, "attempt_sealed", "attempt", header.id.text, false,
                            seal, ""});
  });
}

void abandon_attempt(Database& database, const AttemptId& id) {
  in_transaction(database, "abandon attempt " + id.text, [&] {
    const AttemptHeader header = load_header(database, id);
    if (execute(database,
                "UPDATE attempt SET state = 'interrupted' WHERE uuid = ? AND state = 'recording'",
                header.id.text) != 1) {
      fail_not_recorded(database, "abandon", id);
    }
    append_audit(database, {header.begun.person, "attempt_abandoned", "attempt", header.id.text});
  });
}

}  // namespace hallux::database
