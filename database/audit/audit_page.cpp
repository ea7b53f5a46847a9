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

std::int64_t count_of(Database& database, bool refused_only) {
  // Rows are numbered from 1 without gaps, so that the last number says how many there are.
  return single<std::int64_t>(database, refused_only
                                            ? "SELECT count(*) FROM audit WHERE outcome = 'refused'"
                                            : "SELECT coalesce(max(audit_id), 0) FROM audit");
}

}  // namespace

AuditPage read_audit_page(Database& database, const AuditRequest& request) {
  return translating(database, "read a page of the audit", [&] {
    const auto lines = static_cast<std::size_t>(std::clamp(request.lines, 1, lines_max));
    auto rows = prepared(database,
                         std::string{line_columns} + "WHERE a.audit_id < ?1 " +
                             (request.refused_only ? "AND a.outcome = 'refused' " : "") +
                             "ORDER BY a.audit_id DESC LIMIT ?2",
                         request.before.value_or(std::numeric_limits<std::int64_t>::max()),
                         static_cast<std::int64_t>(lines) + 1);
    AuditPage page;
    while (rows.executeStep()) page.lines.push_back(line_in(rows));
    if (page.lines.size() > lines) {
      page.lines.pop_back();
      page.older = page.lines.back().number;
    }
    page.total = count_of(database, request.refused_only);
    return page;
  });
}

}  // namespace hallux::database
