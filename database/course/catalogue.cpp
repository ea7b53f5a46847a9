/// A version's state is the newest of its rows in scenario_state, so that who published it and when
/// stays to be read. Publishing retires the other version of the name in the same transaction. A
/// number that was published belongs to its text for good, else two attempts with one version would
/// have been made with two plans.
#include "database/course/catalogue.h"

#include <algorithm>

#include "database/audit/audit.h"
#include "database/course/limits.h"
#include "database/course/standings.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

// What a text says of its own review is no review: that column is not read.
constexpr const char* version_columns =
    "SELECT v.scenario_version_id, v.name, v.version, s.state, "
    "coalesce(d.login, ''), s.since_utc, (SELECT count(*) FROM attempt a "
    "WHERE a.scenario_version_id = v.scenario_version_id) "
    "FROM scenario_version v JOIN scenario_state s ON s.scenario_state_id = "
    "(SELECT max(n.scenario_state_id) FROM scenario_state n "
    "WHERE n.scenario_version_id = v.scenario_version_id) "
    "LEFT JOIN person_detail d ON d.person_id = s.person_id ";

ScenarioVersion version_in(SQLite::Statement& row) {
  ScenarioVersion version;
  version.state = ScenarioState::Retired;  // Under a name that is unknown nobody begins it.
  read_columns(row, 0, version.id, version.name, version.version, version.state, version.changed_by,
               version.since_utc, version.attempts);
  return version;
}

std::optional<ScenarioVersion> version_with(Database& database, ScenarioVersionId id) {
  auto row = prepared(database, std::string{version_columns} + "WHERE v.scenario_version_id = ?",
                      id.number);
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
  execute(database,
          "INSERT INTO scenario_state (scenario_version_id, state, person_id, "
          "since_utc) VALUES (?, ?, ?, ?)",
          id.number, name_of(state), by.number, utc_now(database));
  const char* action = state == ScenarioState::Draft       ? "scenario_imported"
                       : state == ScenarioState::Published ? "scenario_published"
                                                           : "scenario_retired";
  append_audit(database, {by, action, "scenario_version", std::to_string(id.number)});
}

/// Whether another text was ever published under the name and the number of this one.
bool has_rival(Database& database, const std::string& name, std::int32_t version,
               ScenarioVersionId but) {
  return single<bool>(database,
                      "SELECT EXISTS (SELECT 1 FROM scenario_version JOIN scenario_state USING "
                      "(scenario_version_id) WHERE name = ? AND version = ? "
                      "AND scenario_version_id <> ? AND state = 'published')",
                      name, version, but.number);
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
    auto rows =
        prepared(database, std::string{version_columns} +
                               "ORDER BY v.name, v.version DESC, v.scenario_version_id DESC");
    return collected(rows, version_in);
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
