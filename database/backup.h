/// A copy of the database while it is used: also while an attempt is being recorded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "database/connection.h"

namespace hallux::database {

struct Backup {
  std::filesystem::path file;
  std::int64_t bytes = 0;
};

/// Thrown where `progress` asked to stop: no file was left.
class BackupStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes `directory`/hallux-DATE-TIME.db: what was committed at one moment, checked, mode 0600. The file appears when it
/// is complete. `progress` is told the part done and may return false to stop.
/// ensures a writer goes on meanwhile; what it commits after the start is not in the copy, and does not delay it
/// errors  DatabaseError: Full where less than twice the size is free; storage failures; BackupStopped
Backup back_up(Database& database, const std::filesystem::path& directory,
               const std::function<bool(double)>& progress = {});

/// Puts what `source` holds into the place of all that `target` holds, in one transaction of `target`.
/// errors  DatabaseError
void copy_whole(Database& source, Database& target);

}  // namespace hallux::database
