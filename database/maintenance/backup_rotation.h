/// Rotation of backups: a new one is made and audited, and old ones are removed.
/// Inside this room only.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "database/maintenance/backup.h"
#include "database/records/ids.h"

namespace hallux::database {

/// The newest ones, and the newest of each of so many days, weeks (from Monday) and months that
/// have one.
struct RotationRule {
  int newest = 10, days = 7, weeks = 4, months = 12;
};

inline constexpr int rotation_most = 1000;

/// What the settings `backups_newest`, `_days`, `_weeks` and `_months` say, within 1 (the newest)
/// or 0 (the others) and 1000; else as above.
RotationRule load_rotation(Database& database);

/// One answer for each of these moments, which are newest first; the newest is always kept.
std::vector<bool> kept_by(const RotationRule& rule, std::span<const std::string> made_utc);

/// Removes the backups of this directory that the rule does not keep, each by its manifest first,
/// and last the recordings that no manifest names. Killed in the middle it leaves whole backups;
/// the next time goes on. Returns what went.
/// errors  DatabaseError: Locked; storage failures
std::vector<std::filesystem::path> rotate_backups(Database& database,
                                                  const std::filesystem::path& folder,
                                                  const RotationRule& rule);

/// Backs up into a folder, or into `backups` of the data directory where `asked` is empty, writes
/// the audit and rotates. Where there is no room for it, the administrators are told.
/// errors  as back_up; BadInput elsewhere in the data directory
Backup back_up_with_rotation(Database& database, const std::filesystem::path& asked,
                             std::optional<PersonId> actor, const BackupOptions& options = {});

}  // namespace hallux::database
