/// A new database is made beside its name and linked there when it is whole, so that an empty file
/// of this name is damage and never the beginning of one. For reading nothing is made or mended.
#include "database/store/connection.h"

#include <sqlite3.h>

#include <chrono>
#include <system_error>
#include <thread>
#include <vector>

#include "database/store/busy_wait.h"
#include "database/store/changed_rows.h"
#include "database/store/durable_file.h"
#include "database/store/file_system.h"
#include "database/store/files.h"
#include "database/store/idle_statements.h"
#include "database/store/log_size.h"
#include "database/store/migrations.h"
#include "database/store/schema_backup.h"
#include "database/store/scratch_directory.h"
#include "database/store/sql.h"
#include "database/store/still_copy.h"
#include "database/store/writer_lease.h"

namespace hallux::database {

namespace {

std::unique_ptr<SQLite::Database> open_file(const std::string& file, int flags,
                                            const OpenOptions& options) {
  try {
    auto connection =
        std::make_unique<SQLite::Database>(file, flags | SQLite::OPEN_NOMUTEX, 0, options.vfs_name);
    wait_when_busy(*connection, options.busy_timeout_ms);
    return connection;
  } catch (const SQLite::Exception& error) {
    throw translated(error, "open the database", file);
  }
}

/// Two processes that make the file at once hinder each other here, and SQLite waits for neither:
/// both would wait for ever.
bool becomes_wal(Database& database) {
  constexpr std::chrono::milliseconds pause{5};
  const auto deadline =
      std::chrono::steady_clock::now() + std::chrono::milliseconds{database.busy_timeout_ms()};
  for (;;) {
    try {
      return single<std::string>(database, "PRAGMA journal_mode = WAL") == "wal";
    } catch (const SQLite::Exception& error) {
      const bool is_busy = (error.getErrorCode() & 0xFF) == SQLITE_BUSY;
      if (!is_busy || std::chrono::steady_clock::now() >= deadline) throw;
    }
    std::this_thread::sleep_for(pause);
  }
}

void check_is_wal(Database& database) {
  if (becomes_wal(database)) return;
  throw DatabaseError{DatabaseErrorKind::ReadOnly,
                      "could not set up " + database.file().string() +
                          ": the file system has no shared memory (a network share?) or is "
                          "read-only; name a local directory with --data"};
}

void configure(Database& database, Access access) {
  translating(database, "set up the connection", [&] {
    SQLite::Database& connection = database.connection();
    sqlite3_db_config(connection.getHandle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    connection.exec("PRAGMA trusted_schema = OFF; PRAGMA foreign_keys = ON;");
    if (access == Access::ReadOnly) return;
    if (sqlite3_db_readonly(connection.getHandle(), "main") == 1) {
      throw DatabaseError{DatabaseErrorKind::ReadOnly,
                          "could not open " + database.file().string() +
                              " for writing: it is read-only; make it writable or name another "
                              "directory with --data"};
    }
    check_is_wal(database);
    // What is erased is overwritten, not only unlinked.
    connection.exec("PRAGMA synchronous = FULL; PRAGMA secure_delete = ON;");
    // SQLite leaves its log as long as it ever was; a slow reader must not fill the disk for good.
    connection.exec("PRAGMA journal_size_limit = " + std::to_string(log_bytes_kept));
  });
}

/// An attempt in state recording whose lease nobody holds lost its writer: killed, crashed, or out
/// of power.
void mark_interrupted_attempts(Database& database) {
  std::vector<AttemptId> abandoned;
  translating(database, "look for interrupted attempts", [&] {
    auto rows = prepared(database, "SELECT uuid FROM attempt WHERE state = 'recording'");
    while (rows.executeStep()) {
      AttemptId attempt{rows.getColumn(0).getString()};
      if (!WriterLease::is_held(database.directory(), attempt)) {
        abandoned.push_back(std::move(attempt));
      }
    }
  });
  for (const AttemptId& attempt : abandoned) {
    in_transaction(database, "mark an interrupted attempt", [&] {
      execute(database,
              "UPDATE attempt SET state = 'interrupted' WHERE uuid = ? AND state = 'recording'",
              attempt.text);
    });
    WriterLease::clear(database.directory(), attempt);
  }
}

void back_up_first(Database& database) {
  if (!is_of_older_schema(database)) return;
  try {
    back_up_before_migration(database);
  } catch (const DatabaseError& error) {
    throw DatabaseError{error.kind(), "the schema of " + database.file().string() +
                                          " is older and was not migrated, because no copy of it "
                                          "could be made before: " +
                                          error.what() +
                                          "; `hallux attempts --no-backup` does without"};
  }
}

}  // namespace

Database::Database(std::filesystem::path directory, const OpenOptions& options)
    : directory_(std::move(directory)), file_(directory_ / "hallux.db"), options_(options) {
  if (options.access == Access::ReadOnly && is_still(directory_)) {
    const StillFile still = still_file(file_);
    copy_ = still.copy;
    const int flags = SQLite::OPEN_URI | (copy_ ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY);
    connection_ = open_file(still.uri, flags, options);
  } else {
    const bool is_writing = options.access == Access::ReadWrite;
    connection_ = open_file(file_.string(),
                            is_writing ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY, options);
  }
  idle_statements_ = std::make_unique<IdleStatements>(*connection_);
}

Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

// Nothing is synced before the whole file is: without a name it is nobody's.
void Database::make(const std::filesystem::path& directory, const OpenOptions& options) {
  const ScratchDirectory scratch{directory};
  make_private_file(scratch.path() / "hallux.db");
  {
    Database made{scratch.path(), options};
    translating(made, "make the tables", [&] {
      made.connection().exec("PRAGMA page_size = 8192; PRAGMA synchronous = OFF;");
      migrate(made);
      check_is_wal(made);
    });
  }
  sync_file(scratch.path() / "hallux.db");
  // Where another process was faster, its file is the database.
  put_in_free_place(scratch.path() / "hallux.db", directory / "hallux.db");
}

Database Database::open(const std::filesystem::path& directory, const OpenOptions& options) {
  const std::filesystem::path file = directory / "hallux.db";
  std::error_code error;
  const bool is_there = std::filesystem::exists(std::filesystem::symlink_status(file, error));
  if (options.access == Access::ReadWrite) {
    check_file_system(directory, options.file_system);
    make_private_directory(directory);
    is_there ? close_to_others(file) : make(directory, options);
  } else if (!is_there) {
    throw DatabaseError{DatabaseErrorKind::NotFound,
                        "there is no database " + file.string() + "; check --data"};
  }
  Database database{directory, options};
  check_schema_is_known(database);
  configure(database, options.access);
  if (options.access == Access::ReadWrite) {
    if (options.backs_up_before_migration) back_up_first(database);
    translating(database, "migrate the schema", [&] { migrate(database); });
    database.changes_ = std::make_unique<ChangedRows>(database.connection().getHandle());
    mark_interrupted_attempts(database);
  } else if (is_of_older_schema(database)) {
    throw DatabaseError{DatabaseErrorKind::ReadOnly,
                        database.file().string() +
                            " has the schema of an older version, which is not read as it is; open "
                            "it once for writing (`hallux attempts`), which keeps a copy of it"};
  }
  return database;
}

Database Database::open_again() const { return open(directory_, options_); }

}  // namespace hallux::database
