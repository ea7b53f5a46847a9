/// Connection to the database file `hallux.db` in a data directory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "database/store/database_error.h"

namespace SQLite {
class Database;
}

namespace hallux::database {

class ChangedRows;
class IdleStatements;

/// "HALX": tells our files from other SQLite databases.
inline constexpr std::int32_t application_id = 0x48414C58;

/// ReadOnly also reads what lies where nothing may be written.
enum class Access { ReadWrite, ReadOnly };

struct OpenOptions {
  /// Only a connection that writes makes, migrates and marks anything.
  Access access = Access::ReadWrite;
  /// The longest wait for another connection that writes [ms].
  int busy_timeout_ms = 5000;
  /// The file system below SQLite; empty: SQLite's own. Tests name one that fails on purpose.
  std::string vfs_name;
  /// The time that rows are stored with, ISO 8601; empty: the clock's. For simulated courses, which
  /// tell of past weeks, and for tests of what expires.
  std::string pretended_utc = {};
  /// What the sign-in guard counts by; empty: this machine's.
  std::string pretended_station = {};
  /// The file system that the directory is on, as a mount table names it; empty: what this system's
  /// says. For tests.
  std::string file_system = {};
  /// A copy of an older database goes into `backups` before its schema is migrated; where it cannot
  /// be made, the migration is refused.
  bool backs_up_before_migration = true;
};

/// A connection with the settings that every connection has.
/// thread  one at a time; another thread gets a connection of its own by open_again()
class Database {
 public:
  /// Opens `directory`/hallux.db. For writing: creates what is missing (directory 0700, file 0600;
  /// the file appears when it is whole), migrates the schema, and marks as interrupted the attempts
  /// whose writer is gone.
  /// A network share is refused for writing: the log needs memory that all who write share.
  /// ensures  WAL, synchronous FULL, foreign keys, busy timeout, no trusted schema; a newer file is
  ///          not touched
  /// errors   DatabaseError: ReadOnly, Full, InputOutput, Newer, Locked; Damaged, also where the
  ///          file is empty; NotFound where reading finds no file
  static Database open(const std::filesystem::path& directory, const OpenOptions& options = {});

  /// Another connection to the same file with the same options, for another thread.
  /// errors   as open
  Database open_again() const;

  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;
  ~Database();

  /// For the files of this room only: SQL is written nowhere else. Valid as long as this object.
  SQLite::Database& connection() noexcept { return *connection_; }
  const SQLite::Database& connection() const noexcept { return *connection_; }
  /// For this room as well: what this transaction changed and no act accounts for yet; nothing of a
  /// connection that only reads.
  ChangedRows* changes() const noexcept { return changes_.get(); }
  /// For this room as well: what it has prepared before.
  IdleStatements& idle_statements() noexcept { return *idle_statements_; }
  /// The data directory, and `hallux.db` in it.
  const std::filesystem::path& directory() const noexcept { return directory_; }
  const std::filesystem::path& file() const noexcept { return file_; }
  int busy_timeout_ms() const noexcept { return options_.busy_timeout_ms; }
  const std::string& vfs_name() const noexcept { return options_.vfs_name; }
  const std::string& pretended_utc() const noexcept { return options_.pretended_utc; }
  const std::string& pretended_station() const noexcept { return options_.pretended_station; }
  /// As the options of the same name, from now on.
  void pretend_it_is(std::string utc) { options_.pretended_utc = std::move(utc); }
  void pretend_to_be(std::string station) { options_.pretended_station = std::move(station); }

 private:
  /// A bare connection to a file that is there.
  Database(std::filesystem::path directory, const OpenOptions& options);
  /// Makes the file of a directory that has none.
  static void make(const std::filesystem::path& directory, const OpenOptions& options);

  std::filesystem::path directory_, file_;
  OpenOptions options_;
  /// That is read where the directory cannot be written.
  std::shared_ptr<const std::filesystem::path> copy_;
  std::unique_ptr<SQLite::Database> connection_;
  /// After the connection, which they watch and are of.
  std::unique_ptr<ChangedRows> changes_;
  std::unique_ptr<IdleStatements> idle_statements_;
};

}  // namespace hallux::database
