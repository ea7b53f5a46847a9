#include "database/store/sql.h"

#include <sqlite3.h>

#include <algorithm>
#include <cerrno>

namespace hallux::database {

namespace {

struct Reason {
  DatabaseErrorKind kind;
  std::string_view text;
};

/// SQLite calls only one of the system's answers a full disk.
bool is_of_full_disk(int extended_code, int system_error) noexcept {
  if ((extended_code & 0xFF) == SQLITE_FULL || extended_code == SQLITE_IOERR_SHMSIZE) return true;
  return (extended_code & 0xFF) == SQLITE_IOERR &&
         (system_error == ENOSPC || system_error == EDQUOT || system_error == EFBIG);
}

Reason reason_of(int extended_code, int system_error) noexcept {
  using enum DatabaseErrorKind;
  if (is_of_full_disk(extended_code, system_error)) {
    return {Full, "the disk is full; free some space and try again"};
  }
  switch (extended_code & 0xFF) {
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return {ReadOnly, "it is read-only; make the directory writable or name another with --data"};
    case SQLITE_CANTOPEN:
      return {ReadOnly, "it cannot be opened; check that the directory exists and is yours"};
    case SQLITE_CORRUPT:
      return {Damaged, "the file is damaged; keep a copy and restore a backup"};
    case SQLITE_ERROR:
      return {Damaged,
              "its tables are not as this program made them; keep a copy and restore a backup"};
    case SQLITE_NOTADB:
      return {Damaged, "the file is not a database; move it away or restore a backup"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {Locked, "another program keeps it busy; close that program and try again"};
    case SQLITE_CONSTRAINT:
      return {BadInput, "a rule of the schema forbids it"};
    default:
      return {InputOutput, "the disk or the file system answered with an error; check the disk"};
  }
}

}  // namespace

DatabaseError translated(const SQLite::Exception& error, std::string_view tried,
                         const std::filesystem::path& file) {
  // Not SQLite's own note of it: that is not taken when a commit fails.
  const int system_error = errno;
  const Reason reason = reason_of(error.getExtendedErrorCode(), system_error);
  return {reason.kind, "could not " + std::string{tried} + " in " + file.string() + ": " +
                           std::string{reason.text} + " (" + error.what() + ")"};
}

bool is_in_transaction(Database& database) noexcept {
  return sqlite3_get_autocommit(database.connection().getHandle()) == 0;
}

std::int64_t page_bytes(Database& database) {
  return translating(database, "ask for the size", [&] {
    return single<std::int64_t>(
        database, "SELECT page_count * page_size FROM pragma_page_count, pragma_page_size");
  });
}

std::string utc_now(Database& database) {
  if (!database.pretended_utc().empty()) return database.pretended_utc();
  return single<std::string>(database, "SELECT strftime('%Y-%m-%dT%H:%M:%fZ', 'now')");
}

void bind_text(SQLite::Statement& statement, int index, std::string_view text) {
  statement.bind(index, std::string{text});
}

std::optional<Digest> digest_in(const SQLite::Column& column) {
  const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
  if (bytes == nullptr || column.getBytes() != 32) return std::nullopt;
  Digest digest;
  std::copy_n(bytes, 32, digest.bytes.begin());
  return digest;
}

}  // namespace hallux::database
