/// Size of SQLite's log (hallux.db-wal), and its limit.
///
/// What is committed stands in the log first. Each commit that leaves more than 1,000 pages (8 MB)
/// there copies them into the database, as far as no reader needs them, and the log is written from
/// its beginning again. It only becomes shorter by the limit that every writer sets, and at the end
/// of an attempt.
#pragma once

#include <cstdint>
#include <filesystem>

#include "database/store/connection.h"

namespace hallux::database {

/// The size [bytes] that a log is cut to when it begins again, where a long reading made it longer.
inline constexpr std::int64_t log_bytes_kept = 16 * 1024 * 1024;

/// The bytes of the log now; 0 where there is none. A look at the file system: cheap enough for
/// once a second.
std::uintmax_t log_bytes(const std::filesystem::path& directory) noexcept;

/// Copies the log into the database and empties it, as far as nobody is reading; waits for nobody.
/// errors  none: what could not be copied stays in the log and is not lost
void shorten_log(Database& database) noexcept;

}  // namespace hallux::database
