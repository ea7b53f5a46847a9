#include "database/store/log_size.h"

#include <sqlite3.h>

#include <system_error>

#include "database/store/busy_wait.h"
#include "database/store/sql.h"

namespace hallux::database {

std::uintmax_t log_bytes(const std::filesystem::path& directory) noexcept {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(directory / "hallux.db-wal", error);
  return error ? 0 : bytes;
}

void shorten_log(Database& database) noexcept {
  never_wait(database.connection());
  sqlite3_wal_checkpoint_v2(database.connection().getHandle(), nullptr, SQLITE_CHECKPOINT_TRUNCATE,
                            nullptr, nullptr);
  wait_when_busy(database.connection(), database.busy_timeout_ms());
}

}  // namespace hallux::database
