/// Erasure of a person: all that names them and all free text of and by them goes; their number,
/// attempts and scores stay as a statistic about nobody
/// (docs/decisions/0008-what-an-erasure-takes.md). Inside this room only.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "database/maintenance/erasure_journal.h"
#include "database/store/connection.h"
#include "simulator/base/progress.h"

namespace hallux::database {

struct ErasureOrder {
  PersonId person;
  /// Their recordings as well, whose scores stay.
  bool with_recordings = false;
  /// Kept in the audit; must not name them.
  std::string reason;
};

struct ErasedPieces {
  std::int64_t texts = 0, recordings = 0, recording_bytes = 0;
  /// False where another program kept reading: SQLite's log beside the database may hold the names
  /// until it ends.
  bool is_log_cleared = false;
};

bool is_erased(Database& database, PersonId person);

/// Writes the journal, erases the recordings one by one where that was ordered, then all else in
/// one transaction, and clears SQLite's log. Killed in the middle it may be done once more.
/// errors  DatabaseError: NotFound; Refused for the last administrator who can sign in, for
///         somebody who is operating, and for somebody erased before; BadInput for the reason;
///         storage failures; Cancelled
ErasedPieces erase_person(Database& database, const ErasureOrder& order,
                          std::optional<PersonId> actor, const Progress& progress = {});

/// What was erased in this directory, as lines of a journal.
std::vector<JournalLine> list_erasures(Database& database);

/// Erases once more whoever `lines` name and who came back with a backup; returns how many. Lines
/// of other directories are passed over, unless `of_any_directory`: of a backup from before
/// directories had an identity.
std::int64_t apply_journal(Database& database, std::span<const JournalLine> lines,
                           bool of_any_directory = false);

/// Moves SQLite's log into the database and cuts it to nothing; false where another program kept
/// reading.
bool clear_log(Database& database);

}  // namespace hallux::database
