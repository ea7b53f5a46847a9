#include "database/cohorts.h"

#include "database/attempts.h"
#include "database/people.h"
#include "database/sql.h"

namespace hallux::database {

namespace {

constexpr const char* cohort_columns =
    "SELECT c.cohort_id, c.name, c.created_utc, "
    "(SELECT count(*) FROM membership m WHERE m.cohort_id = c.cohort_id AND m.role = 'trainee'), "
    "(SELECT count(*) FROM membership m WHERE m.cohort_id = c.cohort_id AND m.role = 'instructor') "
    "FROM cohort c ";

Cohort cohort_in(SQLite::Statement& row) {
  return {{row.getColumn(0).getInt64()},
          row.getColumn(1).getString(),
          row.getColumn(2).getString(),
          row.getColumn(3).getInt(),
          row.getColumn(4).getInt()};
}

CohortRole role_from(const std::string& name) noexcept {
  return name == "trainee" ? CohortRole::Trainee : CohortRole::Instructor;
}

[[noreturn]] void fail_not_found(const Database& database, const std::string& what) {
  throw DatabaseError{
      DatabaseErrorKind::NotFound,
      "there is no " + what + " in " + database.file().string() + "; look at the list of cohorts"};
}

std::int32_t open_help_requests_of(Database& database, PersonId person) {
  SQLite::Statement row{database.connection(),
                        "SELECT count(*) FROM help_request WHERE asker_person_id = ? "
                        "AND answered_utc IS NULL"};
  row.bind(1, person.number);
  row.executeStep();
  return row.getColumn(0).getInt();
}

}  // namespace

CohortId create_cohort(Database& database, const std::string& name) {
  if (name.empty()) {
    throw DatabaseError{DatabaseErrorKind::BadInput, "a cohort needs a name"};
  }
  return in_transaction_of_caller(database, "add a cohort", [&] {
    SQLite::Statement insert{
        database.connection(),
        "INSERT INTO cohort (name, created_utc) VALUES (?, ?) ON CONFLICT (name) DO NOTHING"};
    insert.bind(1, name);
    insert.bind(2, utc_now(database));
    if (insert.exec() == 1) return CohortId{database.connection().getLastInsertRowid()};
    throw DatabaseError{DatabaseErrorKind::BadInput, "there is a cohort '" + name + "' already"};
  });
}

void enrol(Database& database, CohortId cohort, PersonId person, CohortRole role) {
  in_transaction_of_caller(database, "enrol a person", [&] {
    load_person(database, person);
    load_cohort(database, cohort);
    SQLite::Statement insert{
        database.connection(),
        "INSERT INTO membership (cohort_id, person_id, role, enrolled_utc) VALUES (?, ?, ?, ?) "
        "ON CONFLICT (cohort_id, person_id) DO UPDATE SET role = excluded.role, "
        "enrolled_utc = excluded.enrolled_utc"};
    insert.bind(1, cohort.number);
    insert.bind(2, person.number);
    insert.bind(3, role == CohortRole::Trainee ? "trainee" : "instructor");
    insert.bind(4, utc_now(database));
    insert.exec();
  });
}

std::optional<CohortRole> role_in(Database& database, CohortId cohort, PersonId person) {
  return translating(database, "look for a membership", [&]() -> std::optional<CohortRole> {
    SQLite::Statement row{database.connection(),
                          "SELECT role FROM membership WHERE cohort_id = ? AND person_id = ?"};
    row.bind(1, cohort.number);
    row.bind(2, person.number);
    if (!row.executeStep()) return std::nullopt;
    return role_from(row.getColumn(0).getString());
  });
}

std::vector<Cohort> list_cohorts(Database& database) {
  return translating(database, "list the cohorts", [&] {
    SQLite::Statement rows{database.connection(), std::string{cohort_columns} + "ORDER BY c.name"};
    std::vector<Cohort> cohorts;
    while (rows.executeStep()) cohorts.push_back(cohort_in(rows));
    return cohorts;
  });
}

Cohort load_cohort(Database& database, CohortId id) {
  return translating(database, "look for a cohort", [&] {
    SQLite::Statement row{database.connection(),
                          std::string{cohort_columns} + "WHERE c.cohort_id = ?"};
    row.bind(1, id.number);
    if (!row.executeStep()) fail_not_found(database, "cohort " + std::to_string(id.number));
    return cohort_in(row);
  });
}

std::vector<CohortMember> list_members(Database& database, CohortId id) {
  return translating(database, "list the members of a cohort", [&] {
    SQLite::Statement rows{
        database.connection(),
        "SELECT p.person_id, coalesce(d.login, ''), coalesce(d.display_name, ''), m.role, "
        "p.is_disabled, coalesce(m.enrolled_utc, '') FROM membership m JOIN person p USING "
        "(person_id) LEFT JOIN person_detail d USING (person_id) WHERE m.cohort_id = ? "
        "ORDER BY m.role, length(d.login), d.login"};
    rows.bind(1, id.number);
    std::vector<CohortMember> members;
    while (rows.executeStep()) {
      members.push_back({{rows.getColumn(0).getInt64()},
                         rows.getColumn(1).getString(),
                         rows.getColumn(2).getString(),
                         role_from(rows.getColumn(3).getString()),
                         rows.getColumn(4).getInt() != 0,
                         rows.getColumn(5).getString()});
    }
    return members;
  });
}

void remove_from_cohort(Database& database, CohortId cohort, PersonId person) {
  in_transaction_of_caller(database, "take a person out of a cohort", [&] {
    SQLite::Statement remove{database.connection(),
                             "DELETE FROM membership WHERE cohort_id = ? AND person_id = ?"};
    remove.bind(1, cohort.number);
    remove.bind(2, person.number);
    if (remove.exec() == 1) return;
    fail_not_found(database, "such member of cohort " + std::to_string(cohort.number));
  });
}

std::vector<Membership> memberships_of(Database& database, PersonId person) {
  return translating(database, "look for the cohorts of a person", [&] {
    SQLite::Statement rows{database.connection(),
                           "SELECT c.cohort_id, c.name, m.role FROM membership m JOIN cohort c "
                           "USING (cohort_id) WHERE m.person_id = ? ORDER BY c.name"};
    rows.bind(1, person.number);
    std::vector<Membership> memberships;
    while (rows.executeStep()) {
      memberships.push_back({{rows.getColumn(0).getInt64()},
                             rows.getColumn(1).getString(),
                             role_from(rows.getColumn(2).getString())});
    }
    return memberships;
  });
}

std::vector<OperationStanding> operation_standings(Database& database, PersonId person) {
  return translating(database, "gather how a person stands", [&] {
    SQLite::Statement rows{
        database.connection(),
        "WITH result AS (SELECT v.name AS name, a.started_utc AS started_utc, CASE WHEN a.state <> "
        "'void' THEN coalesce(r.score_milli, s.score_milli) END AS milli "
        "FROM attempt a JOIN scenario_version v USING (scenario_version_id) "
        "LEFT JOIN score s ON s.attempt_id = a.attempt_id AND s.superseded_by IS NULL "
        "LEFT JOIN decision r ON r.attempt_id = a.attempt_id AND r.superseded_by IS NULL "
        "WHERE a.person_id = ?) "
        "SELECT name, count(*), max(milli), max(started_utc), (SELECT o.milli FROM result o "
        "WHERE o.name = result.name AND o.milli IS NOT NULL ORDER BY o.started_utc DESC LIMIT 1) "
        "FROM result GROUP BY name ORDER BY name"};
    rows.bind(1, person.number);
    std::vector<OperationStanding> standings;
    while (rows.executeStep()) {
      OperationStanding standing;
      standing.scenario_name = rows.getColumn(0).getString();
      standing.attempts = rows.getColumn(1).getInt();
      if (!rows.getColumn(2).isNull()) standing.best_milli = rows.getColumn(2).getInt64();
      standing.last_started_utc = rows.getColumn(3).getString();
      if (!rows.getColumn(4).isNull()) standing.last_milli = rows.getColumn(4).getInt64();
      standings.push_back(std::move(standing));
    }
    return standings;
  });
}

std::vector<TraineeStanding> list_standings(Database& database, CohortId cohort,
                                            std::int32_t attempts_max) {
  std::vector<TraineeStanding> standings;
  for (const CohortMember& member : list_members(database, cohort)) {
    if (member.role != CohortRole::Trainee) continue;
    AttemptFilter newest;
    newest.person = member.id;
    newest.count_max = attempts_max;
    standings.push_back({member.id, member.login, member.display_name, member.is_disabled,
                         operation_standings(database, member.id), list_attempts(database, newest),
                         open_help_requests_of(database, member.id)});
  }
  return standings;
}

}  // namespace hallux::database
