/// Backups of a data directory, made while it is used: also while an attempt is being recorded.
///
/// A folder of backups:
///
///     hallux-20260301-142507.json    the manifest: digests of what belongs to it; written last
///     hallux-20260301-142507.tables  a database: all tables but the recordings of closed attempts
///     recordings/UUID.recording      chunks and display facts of one closed attempt; written once,
///                                    named by many manifests
///     erasures.jsonl                 the erasures since (database/maintenance/erasure_journal.h)
///     hallux-20260301-142507.db      a whole database in one file: of an older version, or from
///                                    before a migration
///
/// source  docs/decisions/0009-a-backup-shares-its-recordings.md
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "database/store/connection.h"
#include "simulator/base/progress.h"

namespace hallux::database {

struct Backup {
  /// The manifest, or the whole database.
  std::filesystem::path file;
  /// When it was made, to the second.
  std::string made_utc = {};
  /// The uuid of where it was made; "" of a whole database.
  std::string directory = {};
  /// The size of all that belongs to it.
  std::int64_t bytes = 0;
  std::int64_t recordings = 0;
  /// The part of it that this backup wrote; 0 in a list.
  std::int64_t new_bytes = 0;
  /// Attempts whose chain did not hold; their rows are kept as they are.
  std::int64_t damaged = 0;
  /// Of the audit when it was begun, as a line (database/audit/anchors.h); "" in a list.
  std::string anchor = {};
};

struct BackupOptions {
  /// Told the fraction done [0, 1]; false cancels.
  Progress progress = {};
  /// For tests of a disk that fills.
  std::optional<std::uintmax_t> pretended_free_bytes = {};
};

/// Writes into `folder`: first the recordings that are not there yet, each read for itself, then
/// the tables from one snapshot, then the manifest.
/// ensures a writer goes on meanwhile; what it commits after the snapshot is not in the copy, and
///         does not delay it
/// errors  DatabaseError: Full where less than twice what is to be written is free; Locked where
///         another backup is being made; storage failures; Cancelled
Backup back_up(Database& database, const std::filesystem::path& folder,
               const BackupOptions& options = {});

/// Newest first: those that are complete, of both forms. None where there is no folder.
std::vector<Backup> list_backups(const std::filesystem::path& folder);

/// Puts what `source` holds into the place of all that `target` holds, in one transaction of
/// `target`.
/// errors  DatabaseError
void copy_whole(Database& source, Database& target);

}  // namespace hallux::database
