/// Verification of everything that is sealed; it names the first row that was altered.
///
/// It shows alterations by whoever does not also recompute the chains; it cannot show that the
/// newest unsealed rows or the last audit rows were cut off, nor that the owner of the files wrote
/// all of them anew.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "database/records/ids.h"
#include "database/store/connection.h"
#include "simulator/base/progress.h"

namespace hallux::database {

struct Verification {
  /// Found whole.
  std::int64_t attempts = 0, chunks = 0, scores = 0, assets = 0, audit_rows = 0;
  /// When the audit began to account for every row; nothing in one that was not migrated yet.
  std::optional<std::string> covered_since_utc;
  /// One sentence naming file and row; nothing: all is well.
  std::optional<std::string> first_damage;

  bool is_whole() const noexcept { return !first_damage.has_value(); }
};

/// SQLite's own checks, the schema, every chunk chain, seal, score, asset, scenario text and the
/// audit chain; that what the audit names is there unaltered, that no attempt, score, decision or
/// administrator is there that it does not name, and that every row of the tables that it accounts
/// for (database/store/changed_rows.h) is as its newest act left it. Reads in pieces: a recording
/// goes on meanwhile, and no more is held than some hundred rows. `progress` is told the part done
/// and may return false to stop.
/// errors  DatabaseError for storage failures other than damage; Cancelled
Verification verify(Database& database, const Progress& progress = {});

}  // namespace hallux::database
