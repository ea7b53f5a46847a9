#include "database/audit/audit_page.h"

#include <algorithm>
#include <limits>

#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr std::int32_t lines_max = 500;

/// A subject that can be named is a person, a cohort, a scenario version, or the person of a
/// membership ("cohort/person").
constexpr const char* line_columns =
    "SELECT a.audit_id, a.at_utc, coalesce(d.login, ''), a.action, a.subject_kind, a.subject_id, "
    "coalesce(CASE a.subject_kind "
    "WHEN 'person' THEN (SELECT login FROM person_detail WHERE person_id = a.subject_id) "
    "WHEN 'membership' THEN (SELECT login FROM person_detail WHERE person_id = "
    "substr(a.subject_id, instr(a.subject_id, '/') + 1)) "
    "WHEN 'cohort' THEN (SELECT name FROM cohort WHERE cohort_id = a.subject_id) "
    "WHEN 'scenario_version' THEN (SELECT name || ' version ' || version FROM scenario_version "
    "WHERE scenario_version_id = a.subject_id) END, ''), "
    "a.outcome = 'refused', coalesce(t.text, '') FROM audit a "
    "LEFT JOIN person_detail d ON d.person_id = a.actor_person_id "
    "LEFT JOIN audit_text t ON t.audit_id = a.audit_id ";

AuditLine line_in(SQLite::Statement& row) {
  return {
      row.getColumn(0).getInt64(),  row.getColumn(1).getString(),   row.getColumn(2).getString(),
      row.getColumn(3).getString(), row.getColumn(4).getString(),   row.getColumn(5).getString(),
      row.getColumn(6).getString(), row.getColumn(7).getInt() != 0, row.getColumn(8).getString()};
}

/// ?1 is what is sought. A person is the subject by themself, as the member of a cohort, or by an
/// attempt of theirs.
constexpr const char* is_found =
    "(a.actor_person_id IN sought "
    "OR (a.subject_kind = 'person' AND CAST(a.subject_id AS INTEGER) IN sought) "
    "OR (a.subject_kind = 'membership' AND CAST(substr(a.subject_id, instr(a.subject_id, '/') + 1) "
    "AS INTEGER) IN sought) "
    "OR (a.subject_kind = 'attempt' AND a.subject_id IN "
    "(SELECT uuid FROM attempt WHERE person_id IN sought)) "
    "OR instr(lower(t.text), lower(?1)) > 0) ";
constexpr const char* with_sought =
    "WITH sought AS (SELECT person_id FROM person_detail WHERE "
    "instr(lower(login), lower(?1)) > 0 OR instr(lower(display_name), lower(?1)) > 0) ";

/// "AND ..." for each thing that was asked for.
std::string conditions_of(const AuditRequest& request) {
  std::string conditions;
  if (request.refused_only) conditions += "AND a.outcome = 'refused' ";
  if (!request.search.empty()) conditions += std::string{"AND "} + is_found;
  return conditions;
}

std::int64_t count_of(Database& database, const AuditRequest& request) {
  // Rows are numbered from 1 without gaps, so that the last number says how many there are.
  if (!request.refused_only && request.search.empty()) {
    return single<std::int64_t>(database, "SELECT coalesce(max(audit_id), 0) FROM audit");
  }
  return single<std::int64_t>(database,
                              std::string{with_sought} +
                                  "SELECT count(*) FROM audit a LEFT JOIN audit_text t ON "
                                  "t.audit_id = a.audit_id WHERE ?1 = ?1 " +
                                  conditions_of(request),
                              request.search);
}

}  // namespace

AuditPage read_audit_page(Database& database, const AuditRequest& request) {
  return translating(database, "read a page of the audit", [&] {
    const auto lines = static_cast<std::size_t>(std::clamp(request.lines, 1, lines_max));
    auto rows =
        prepared(database,
                 std::string{with_sought} + line_columns + "WHERE a.audit_id < ?2 " +
                     conditions_of(request) + "ORDER BY a.audit_id DESC LIMIT ?3",
                 request.search, request.before.value_or(std::numeric_limits<std::int64_t>::max()),
                 static_cast<std::int64_t>(lines) + 1);
    AuditPage page;
    while (rows.executeStep()) page.lines.push_back(line_in(rows));
    if (page.lines.size() > lines) {
      page.lines.pop_back();
      page.older = page.lines.back().number;
    }
    page.total = count_of(database, request);
    return page;
  });
}

}  // namespace hallux::database
