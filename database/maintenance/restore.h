/// Restoring a backup into a fresh data directory: whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "database/store/connection.h"
#include "simulator/base/progress.h"

namespace hallux::database {

struct RestoreOrder {
  /// A manifest, a whole database, or a folder: its newest backup.
  std::filesystem::path backup;
  /// Must not be there, or be empty.
  std::filesystem::path directory;
  /// A newer journal of erasures than the one beside the backup; may be empty.
  std::filesystem::path journal;
  /// What is whole comes back although a recording or a row is not; the tables must be what the
  /// manifest says.
  bool even_damaged = false;
};

struct Restored {
  /// The backup that was restored.
  std::filesystem::path backup;
  std::string made_utc;
  std::int64_t attempts = 0, recordings = 0;
  /// People whom the journal of erasures erased once more.
  std::int64_t erased_people = 0;
  /// Only where it was restored even damaged.
  std::optional<std::string> first_damage = {};
};

/// Copies the backup beside `directory`, checking each digest, puts the recordings back, applies
/// the journal of erasures, verifies all chains and seals, and names the result `directory` at the
/// end. Nothing in the backup is altered, nothing outside its folder is read, no link is followed.
/// errors  DatabaseError: NotFound; Damaged, Newer, BadInput for the backup; Refused where the
///         directory holds something; storage failures; Cancelled. Even damaged: the tables must
///         still be what the manifest says. Then nothing was left; what a kill left is cleared by
///         the next try
Restored restore(const RestoreOrder& order, const Progress& progress = {});

}  // namespace hallux::database
