#include "database/maintenance/verify_rows.h"

#include <map>
#include <string>

#include "database/audit/row_accounts.h"
#include "database/store/migrations.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// By kind and name, the statement that made it.
using Schema = std::map<std::string, std::string>;

Schema schema_in(SQLite::Database& connection) {
  SQLite::Statement rows{connection,
                         "SELECT type || ' ' || name, sql FROM sqlite_schema WHERE sql IS NOT NULL "
                         "AND name NOT LIKE 'sqlite_%'"};
  Schema schema;
  while (rows.executeStep()) {
    schema.emplace(rows.getColumn(0).getString(), rows.getColumn(1).getString());
  }
  return schema;
}

Schema schema_of_version(std::int32_t version) {
  SQLite::Database made{":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
  for (std::int32_t i = 0; i < version; ++i) made.exec(schema_statements(i));
  return schema_in(made);
}

}  // namespace

void check_schema(Database& database) {
  translating(database, "check the schema", [&] {
    const auto version = single<std::int32_t>(database, "PRAGMA user_version");
    if (version < 1) fail_altered(database, "the version of the schema");
    const Schema expected = schema_of_version(version), there = schema_in(database.connection());
    for (const auto& [name, sql] : expected) {
      const auto found = there.find(name);
      if (found == there.end()) fail_altered(database, "the schema, without its " + name + ",");
      if (found->second != sql) fail_altered(database, "the schema in its " + name);
    }
    for (const auto& [name, sql] : there) {
      if (!expected.contains(name)) {
        fail_altered(database, "the schema, in which another program put " + name + ",");
      }
    }
  });
}

void check_rows(Database& database, VerifyProgress& progress, Verification& found) {
  progress.begin("the rows", 1.0);
  translating(database, "compare the rows with the audit", [&] {
    const bool has_accounts = single<bool>(
        database,
        "SELECT EXISTS (SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = 'audit_row')");
    if (!has_accounts) return;
    const std::optional<Baseline> baseline = first_baseline(database);
    if (!baseline) fail_altered(database, "the baseline of the audit, which is missing,");
    found.covered_since_utc = baseline->at_utc;
    std::int64_t done = 0;
    for (const AccountedTable& table : accounted_tables) {
      if (const auto row = first_unaccounted(database, table)) {
        fail_altered(database, row->row + ", which " + row->how + ",");
      }
      progress.tell(++done, static_cast<std::int64_t>(accounted_tables.size()));
    }
  });
}

}  // namespace hallux::database
