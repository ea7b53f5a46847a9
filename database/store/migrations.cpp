#include "database/store/migrations.h"

#include <span>

#include "database/store/changed_rows.h"
#include "database/store/sql.h"
#include "simulator/base/embedded.h"

namespace hallux::database {

std::span<const EmbeddedText> schema_files() noexcept;

namespace {

std::int32_t pragma_number(Database& database, const char* pragma) {
  return single<std::int32_t>(database, pragma);
}

bool has_tables(Database& database) {
  return pragma_number(database, "SELECT count(*) FROM sqlite_schema") > 0;
}

}  // namespace

std::int32_t newest_schema() noexcept { return static_cast<std::int32_t>(schema_files().size()); }

std::string schema_statements(std::int32_t index) {
  return std::string{schema_files()[static_cast<std::size_t>(index)].text};
}

void check_schema_is_known(Database& database) {
  translating(database, "read the schema version", [&] {
    // One moment for all of it: another process may be making the file.
    const SQLite::Transaction moment{database.connection()};
    const std::int32_t found = pragma_number(database, "PRAGMA user_version");
    const std::int32_t owner = pragma_number(database, "PRAGMA application_id");
    if (owner == 0 && found == 0 && !has_tables(database)) {
      throw DatabaseError{DatabaseErrorKind::Damaged,
                          database.file().string() +
                              " is empty, which no database of this program ever is: it was "
                              "overwritten or lost; keep a copy and restore a backup (hallux "
                              "restore). Where nothing was ever kept there, remove the file"};
    }
    if (owner != application_id) {
      throw DatabaseError{
          DatabaseErrorKind::Damaged,
          database.file().string() +
              " is a database of another program; name another directory with --data"};
    }
    if (found > newest_schema()) {
      throw DatabaseError{DatabaseErrorKind::Newer,
                          database.file().string() + " has schema " + std::to_string(found) +
                              " of a newer version of this program, which knows schema " +
                              std::to_string(newest_schema()) +
                              "; install the newer version, nothing was changed"};
    }
  });
}

bool is_of_older_schema(Database& database) {
  return translating(database, "read the schema version", [&] {
    const std::int32_t found = pragma_number(database, "PRAGMA user_version");
    return found > 0 && found < newest_schema();
  });
}

void migrate(Database& database) {
  const auto files = schema_files();
  if (pragma_number(database, "PRAGMA user_version") == newest_schema()) return;
  for (std::size_t i = 0; i < files.size(); ++i) {
    in_transaction(database, "migrate to " + std::string{files[i].name}, [&] {
      // Read inside the transaction: a second process may have migrated in the meantime.
      if (pragma_number(database, "PRAGMA user_version") > static_cast<std::int32_t>(i)) return;
      database.connection().exec(std::string{files[i].text});
      database.connection().exec("PRAGMA application_id = " + std::to_string(application_id));
      database.connection().exec("PRAGMA user_version = " + std::to_string(i + 1));
      if (i + 1 == files.size()) take_baseline(database);
    });
  }
}

}  // namespace hallux::database
