#include "database/log_size.h"

#include <sqlite3.h>

#include <system_error>

#include "database/sql.h"

namespace hallux::database {

std::uintmax_t log_bytes(const std::filesystem::path& directory) noexcept {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(directory / "hallux.db-wal", error);
  return error ? 0 : bytes;
}

void shorten_log(Database& database) noexcept {
  sqlite3* connection = database.connection().getHandle();
  sqlite3_busy_timeout(connection, 0);
  sqlite3_wal_checkpoint_v2(connection, nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
  sqlite3_busy_timeout(connection, database.busy_timeout_ms());
}

}  // namespace hallux::database
