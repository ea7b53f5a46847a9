#include "database/course/catalogue.h"

#include <algorithm>

#include "database/audit/audit.h"
#include "database/course/limits.h"
#include "database/course/standings.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr const char* version_columns =
    "SELECT v.scenario_version_id, v.name, v.version, v.is_reviewed, s.state, "
    "coalesce(d.login, ''), s.since_utc, (SELECT count(*) FROM attempt a "
    "WHERE a.scenario_version_id = v.scenario_version_id) "
    "FROM scenario_version v JOIN scenario_state s ON s.scenario_state_id = "
    "(SELECT max(n.scenario_state_id) FROM scenario_state n "
    "WHERE n.scenario_version_id = v.scenario_version_id) "
    "LEFT JOIN person_detail d ON d.person_id = s.person_id ";

ScenarioVersion version_in(SQLite::Statement& row) {
  ScenarioVersion version;
  version.id = {row.getColumn(0).getInt64()};
  version.name = row.getColumn(1).getString();
  version.version = row.getColumn(2).getInt();
  version.is_reviewed = row.getColumn(3).getInt() != 0;
  version.state =
      scenario_state_from(row.getColumn(4).getString()).value_or(ScenarioState::Retired);
  version.changed_by = row.getColumn(5).getString();
  version.since_utc = row.getColumn(6).getString();
  version.attempts = row.getColumn(7).getInt();
  return version;
}

std::optional<ScenarioVersion> version_with(Database& database, ScenarioVersionId id) {
  SQLite::Statement row{database.connection(),
                        std::string{version_columns} + "WHERE v.scenario_version_id = ?"};
  row.bind(1, id.number);
  if (!row.executeStep()) return std::nullopt;
  return version_in(row);
}

std::string shown_name(const ScenarioVersion& version) {
  return version.name + " version " + std::to_string(version.version);
}

[[noreturn]] void refuse(const std::string& sentence) {
  throw DatabaseError{DatabaseErrorKind::BadInput, sentence};
}

/// Stores the state and its audit row: "scenario_published".
void set_state(Database& database, ScenarioVersionId id, ScenarioState state, PersonId by) {
  SQLite::Statement insert{database.connection(),
                           "INSERT INTO scenario_state (scenario_version_id, state, person_id, "
                           "since_utc) VALUES (?, ?, ?, ?)"};
  insert.bind(1, id.number);
  bind_text(insert, 2, name_of(state));
  insert.bind(3, by.number);
  insert.bind(4, utc_now(database));
  insert.exec();
  const char* action = state == ScenarioState::Draft       ? "scenario_imported"
                       : state == ScenarioState::Published ? "scenario_published"
                                                           : "scenario_retired";
  append_audit(database,
               {by, action, "scenario_version", std::to_string(id.number), false, {}, ""});
}

/// Whether another text was ever published under the name and the number of this one.
bool has_rival(Database& database, const std::string& name, std::int32_t version,
               ScenarioVersionId but) {
  SQLite::Statement row{database.connection(),
                        "SELECT EXISTS (SELECT 1 FROM scenario_version JOIN scenario_state USING "
                        "(scenario_version_id) WHERE name = ? AND version = ? "
                        "AND scenario_version_id <> ? AND state = 'published')"};
  row.bind(1, name);
  row.bind(2, version);
  row.bind(3, but.number);
  row.executeStep();
  return row.getColumn(0).getInt() != 0;
}

void check_no_rival(Database& database, const ScenarioText& text, ScenarioVersionId id) {
  if (!has_rival(database, text.name, text.version, id)) return;
  refuse("another text was published as " + text.name + " version " + std::to_string(text.version) +
         "; raise the number in the file");
}

}  // namespace

ScenarioVersionId import_scenario(Database& database, const ScenarioText& text, PersonId by) {
  const ScenarioVersionId id = put_scenario_version(database, text);
  return in_transaction(database, "import a scenario", [&] {
    check_no_rival(database, text, id);
    if (!version_with(database, id)) set_state(database, id, ScenarioState::Draft, by);
    return id;
  });
}

void publish_scenario(Database& database, ScenarioVersionId id, PersonId by) {
  in_transaction(database, "publish a scenario", [&] {
    const ScenarioVersion wanted = load_scenario_version(database, id);
    if (wanted.state == ScenarioState::Published) refuse(shown_name(wanted) + " is published");
    check_no_rival(database, {wanted.name, wanted.version, "", false}, id);
    for (const ScenarioVersion& other : list_scenario_versions(database)) {
      if (other.name == wanted.name && other.state == ScenarioState::Published) {
        set_state(database, other.id, ScenarioState::Retired, by);
      }
    }
    set_state(database, id, ScenarioState::Published, by);
  });
}

void retire_scenario(Database& database, ScenarioVersionId id, PersonId by) {
  in_transaction(database, "retire a scenario", [&] {
    const ScenarioVersion version = load_scenario_version(database, id);
    if (version.state != ScenarioState::Published) {
      refuse(shown_name(version) + " is not published; only what is published can be retired");
    }
    set_state(database, id, ScenarioState::Retired, by);
  });
}

std::vector<ScenarioVersion> list_scenario_versions(Database& database) {
  return translating(database, "list the scenario versions", [&] {
    SQLite::Statement rows{database.connection(),
                           std::string{version_columns} +
                               "ORDER BY v.name, v.version DESC, v.scenario_version_id DESC"};
    std::vector<ScenarioVersion> versions;
    while (rows.executeStep()) versions.push_back(version_in(rows));
    return versions;
  });
}

ScenarioVersion load_scenario_version(Database& database, ScenarioVersionId id) {
  return translating(database, "look for a scenario version", [&] {
    if (auto version = version_with(database, id)) return *version;
    throw DatabaseError{DatabaseErrorKind::NotFound,
                        "the catalogue of " + database.file().string() +
                            " has no scenario version " + std::to_string(id.number) +
                            "; import it first"};
  });
}

bool is_published(Database& database, ScenarioVersionId id) {
  return translating(database, "look whether a scenario is published", [&] {
    const auto version = version_with(database, id);
    return version && version->state == ScenarioState::Published;
  });
}

std::vector<Operation> list_operations(Database& database, PersonId person) {
  const std::vector<OperationStanding> standings = operation_standings(database, person);
  std::vector<Operation> operations;
  for (const ScenarioVersion& version : list_scenario_versions(database)) {
    if (version.state != ScenarioState::Published) continue;
    Operation operation;
    operation.scenario = version.id;
    operation.name = operation.standing.scenario_name = version.name;
    operation.version = version.version;
    operation.is_reviewed = version.is_reviewed;
    operation.published_utc = version.since_utc;
    operation.allowance = allowance_of(database, person, version.name);
    const auto own = std::find_if(
        standings.begin(), standings.end(),
        [&](const OperationStanding& standing) { return standing.scenario_name == version.name; });
    if (own != standings.end()) operation.standing = *own;
    operations.push_back(std::move(operation));
  }
  return operations;
}

}  // namespace hallux::database
