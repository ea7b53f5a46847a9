/// What uses up a limit is counted when it is asked, not kept: an attempt that is voided, found not
/// valid or of an origin that is no longer accepted gives its place back by itself. One that was
/// interrupted counts once a tooth touched bone; whoever loses the recording wins no attempt by it.
#include "database/course/limits.h"

#include <algorithm>

#include "database/audit/audit.h"
#include "database/people/cohorts.h"
#include "database/recording/recordings.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

[[noreturn]] void fail_not_found(const Database& database, const std::string& what) {
  throw DatabaseError{DatabaseErrorKind::NotFound,
                      "there is no " + what + " in " + database.file().string()};
}

void check_operation_is_known(Database& database, const std::string& scenario_name) {
  auto row = prepared(database, "SELECT 1 FROM scenario_version WHERE name = ?", scenario_name);
  if (!row.executeStep()) fail_not_found(database, "operation '" + scenario_name + "'");
}

std::string audit_subject(CohortId cohort, const std::string& scenario_name, std::int32_t number) {
  return std::to_string(cohort.number) + "/" + scenario_name + "/" + std::to_string(number);
}

bool is_touch(const simulator::CutEvent& event) noexcept {
  return event.kind == simulator::CutEventKind::Scratch ||
         event.kind == simulator::CutEventKind::Contact;
}

/// Whether a tooth touched bone. A recording that was erased or cannot be read is taken for one
/// that did: nobody wins an attempt by losing it.
bool has_touched_bone(Database& database, const AttemptId& attempt) {
  try {
    const simulator::Recording recording =
        load_recording(database, attempt, RecordingPart::Outputs);
    return std::any_of(recording.events.begin(), recording.events.end(), is_touch);
  } catch (const DatabaseError& error) {
    if (error.kind() == DatabaseErrorKind::NotFound || error.kind() == DatabaseErrorKind::Damaged)
      return true;
    throw;
  }
}

/// When the assessments were begun that use up a limit.
std::vector<std::string> used_assessments(Database& database, PersonId person,
                                          const std::string& scenario_name) {
  auto rows = prepared(
      database,
      "SELECT a.uuid, a.started_utc, a.state FROM attempt a JOIN scenario_version v "
      "USING (scenario_version_id) LEFT JOIN origin o ON o.origin_id = a.origin_id "
      "WHERE a.person_id = ? AND v.name = ? AND a.kind = 'assessment' AND a.state <> 'void' "
      "AND coalesce(a.is_valid, 1) = 1 AND coalesce(o.is_accepted, 1) = 1",
      person.number, scenario_name);
  std::vector<std::string> begun_utc;
  while (rows.executeStep()) {
    if (rows.getColumn(2).getString() == "interrupted" &&
        !has_touched_bone(database, {rows.getColumn(0).getString()}))
      continue;
    begun_utc.push_back(rows.getColumn(1).getString());
  }
  return begun_utc;
}

std::string name_of_operation(Database& database, ScenarioVersionId scenario) {
  return found<std::string>(
             database, "SELECT name FROM scenario_version WHERE scenario_version_id = ?", scenario)
      .value_or("");
}

}  // namespace

std::vector<AttemptLimit> list_limits(Database& database, CohortId cohort) {
  return translating(database, "list the limits of a cohort", [&] {
    auto rows = prepared(database,
                         "SELECT l.scenario_name, l.attempts_max, coalesce(d.login, ''), "
                         "l.set_utc FROM attempt_limit l LEFT JOIN person_detail d "
                         "ON d.person_id = l.set_by_person_id WHERE l.cohort_id = ? "
                         "ORDER BY l.scenario_name",
                         cohort.number);
    return rows_of(std::move(rows), &AttemptLimit::scenario_name, &AttemptLimit::attempts_max,
                   &AttemptLimit::set_by, &AttemptLimit::set_utc);
  });
}

void set_limit(Database& database, CohortId cohort, const AttemptLimit& limit, PersonId by) {
  if (limit.attempts_max < 1 || limit.attempts_max > attempts_max_most) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "a limit lies between 1 and " + std::to_string(attempts_max_most) +
                            " assessments; take the limit away to allow as many as they like"};
  }
  in_transaction(database, "limit the assessments of an operation", [&] {
    load_cohort(database, cohort);
    check_operation_is_known(database, limit.scenario_name);
    execute(database,
            "INSERT INTO attempt_limit (cohort_id, scenario_name, attempts_max, set_by_person_id, "
            "set_utc) VALUES (?, ?, ?, ?, ?) ON CONFLICT (cohort_id, scenario_name) DO UPDATE SET "
            "attempts_max = excluded.attempts_max, set_by_person_id = excluded.set_by_person_id, "
            "set_utc = excluded.set_utc",
            cohort.number, limit.scenario_name, limit.attempts_max, by.number, utc_now(database));
    append_audit(database, {by, "limit_set", "attempt_limit",
                            audit_subject(cohort, limit.scenario_name, limit.attempts_max)});
  });
}

void clear_limit(Database& database, CohortId cohort, const std::string& scenario_name,
                 PersonId by) {
  in_transaction(database, "take a limit away", [&] {
    if (execute(database, "DELETE FROM attempt_limit WHERE cohort_id = ? AND scenario_name = ?",
                cohort.number, scenario_name) != 1)
      fail_not_found(database, "limit of '" + scenario_name + "'");
    append_audit(database,
                 {by, "limit_cleared", "attempt_limit", audit_subject(cohort, scenario_name, 0)});
  });
}

std::optional<AttemptAllowance> allowance_of(Database& database, PersonId person,
                                             const std::string& scenario_name) {
  return translating(database, "count the assessments that are left", [&] {
    auto limits = prepared(
        database,
        "SELECT l.attempts_max, c.name, coalesce(m.enrolled_utc, '') FROM membership m "
        "JOIN attempt_limit l ON l.cohort_id = m.cohort_id AND l.scenario_name = ?2 "
        "JOIN cohort c ON c.cohort_id = m.cohort_id WHERE m.person_id = ?1 AND m.role = 'trainee' "
        "ORDER BY c.name",
        person.number, scenario_name);
    std::optional<AttemptAllowance> strictest;
    std::optional<std::vector<std::string>> begun_utc;
    while (limits.executeStep()) {
      if (!begun_utc) begun_utc = used_assessments(database, person, scenario_name);
      const std::string enrolled_utc = limits.getColumn(2).getString();
      const auto used =
          std::count_if(begun_utc->begin(), begun_utc->end(),
                        [&](const std::string& begun) { return begun >= enrolled_utc; });
      const AttemptAllowance allowance{static_cast<std::int32_t>(used),
                                       limits.getColumn(0).getInt(),
                                       limits.getColumn(1).getString()};
      if (!strictest || allowance.left() < strictest->left()) strictest = allowance;
    }
    return strictest;
  });
}

void check_allowance(Database& database, const NewAttempt& attempt) {
  if (!attempt.person || attempt.kind != AttemptKind::Assessment) return;
  const std::string name = name_of_operation(database, attempt.scenario);
  const auto allowance = allowance_of(database, *attempt.person, name);
  if (!allowance || allowance->left() > 0) return;
  throw DatabaseError{DatabaseErrorKind::Refused,
                      "you have used " + std::to_string(allowance->used) + " of the " +
                          std::to_string(allowance->attempts_max) + " assessments of '" + name +
                          "' that the cohort " + allowance->cohort_name +
                          " allows; its instructors and the administrators can change that, and "
                          "practice is not limited"};
}

}  // namespace hallux::database
