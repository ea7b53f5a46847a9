#include "database/people/cohorts.h"

#include "database/people/people.h"
#include "database/store/sql.h"
#include "database/text/free_text.h"

namespace hallux::database {

namespace {

constexpr const char* cohort_columns =
    "SELECT c.cohort_id, c.name, c.created_utc, "
    "(SELECT count(*) FROM membership m WHERE m.cohort_id = c.cohort_id AND m.role = 'trainee'), "
    "(SELECT count(*) FROM membership m WHERE m.cohort_id = c.cohort_id AND m.role = 'instructor') "
    "FROM cohort c ";

Cohort cohort_in(SQLite::Statement& row) {
  Cohort cohort;
  read_columns(row, 0, cohort.id, cohort.name, cohort.created_utc, cohort.trainees,
               cohort.instructors);
  return cohort;
}

[[noreturn]] void fail_not_found(const Database& database, const std::string& what) {
  throw DatabaseError{
      DatabaseErrorKind::NotFound,
      "there is no " + what + " in " + database.file().string() + "; look at the list of cohorts"};
}

}  // namespace

CohortId create_cohort(Database& database, const std::string& name) {
  if (name.empty()) {
    throw DatabaseError{DatabaseErrorKind::BadInput, "a cohort needs a name"};
  }
  check_name("the name of the cohort", name);
  return in_transaction_of_caller(database, "add a cohort", [&] {
    if (execute(
            database,
            "INSERT INTO cohort (name, created_utc) VALUES (?, ?) ON CONFLICT (name) DO NOTHING",
            name, utc_now(database)) == 1)
      return CohortId{database.connection().getLastInsertRowid()};
    throw DatabaseError{DatabaseErrorKind::BadInput, "there is a cohort '" + name + "' already"};
  });
}

void enrol(Database& database, CohortId cohort, PersonId person, CohortRole role) {
  in_transaction_of_caller(database, "enrol a person", [&] {
    load_person(database, person);
    load_cohort(database, cohort);
    execute(database,
            "INSERT INTO membership (cohort_id, person_id, role, enrolled_utc) VALUES (?, ?, ?, ?) "
            "ON CONFLICT (cohort_id, person_id) DO UPDATE SET role = excluded.role, "
            "enrolled_utc = excluded.enrolled_utc WHERE role <> excluded.role",
            cohort.number, person.number, role, utc_now(database));
  });
}

std::optional<CohortRole> role_in(Database& database, CohortId cohort, PersonId person) {
  return translating(database, "look for a membership", [&] {
    return found<CohortRole>(database,
                             "SELECT role FROM membership WHERE cohort_id = ? AND person_id = ?",
                             cohort, person);
  });
}

std::vector<Cohort> list_cohorts(Database& database) {
  return translating(database, "list the cohorts", [&] {
    auto rows = prepared(database, std::string{cohort_columns} + "ORDER BY c.name");
    return collected(rows, cohort_in);
  });
}

Cohort load_cohort(Database& database, CohortId id) {
  return translating(database, "look for a cohort", [&] {
    auto row = prepared(database, std::string{cohort_columns} + "WHERE c.cohort_id = ?", id.number);
    if (!row.executeStep()) fail_not_found(database, "cohort " + std::to_string(id.number));
    return cohort_in(row);
  });
}

std::vector<CohortMember> list_members(Database& database, CohortId id) {
  return translating(database, "list the members of a cohort", [&] {
    auto rows = prepared(
        database,
        "SELECT p.person_id, coalesce(d.login, ''), coalesce(d.display_name, ''), m.role, "
        "p.is_disabled, coalesce(m.enrolled_utc, '') FROM membership m JOIN person p USING "
        "(person_id) LEFT JOIN person_detail d USING (person_id) WHERE m.cohort_id = ? "
        "ORDER BY m.role, length(d.login), d.login",
        id.number);
    return rows_of(std::move(rows), &CohortMember::id, &CohortMember::login,
                   &CohortMember::display_name, &CohortMember::role, &CohortMember::is_disabled,
                   &CohortMember::enrolled_utc);
  });
}

void remove_from_cohort(Database& database, CohortId cohort, PersonId person) {
  in_transaction_of_caller(database, "take a person out of a cohort", [&] {
    if (execute(database, "DELETE FROM membership WHERE cohort_id = ? AND person_id = ?",
                cohort.number, person.number) == 1)
      return;
    fail_not_found(database, "such member of cohort " + std::to_string(cohort.number));
  });
}

std::vector<Membership> memberships_of(Database& database, PersonId person) {
  return translating(database, "look for the cohorts of a person", [&] {
    auto rows = prepared(database,
                         "SELECT c.cohort_id, c.name, m.role FROM membership m JOIN cohort c "
                         "USING (cohort_id) WHERE m.person_id = ? ORDER BY c.name",
                         person.number);
    return rows_of(std::move(rows), &Membership::cohort, &Membership::cohort_name,
                   &Membership::role);
  });
}

}  // namespace hallux::database
