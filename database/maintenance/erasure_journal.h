/// The journal of erasures: a file beside the backups, so that a backup from before an erasure does
/// not bring anybody back. Inside this corner only.
///
/// `backups/erasures.jsonl` of the data directory, and a copy in every folder that backups are
/// written to. A line is one erasure: numbers and times, no name. It is written before the rows are
/// erased; a line that was cut by a power cut is one whose erasure did not happen, and is taken
/// away by the next one.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "database/records/ids.h"

namespace hallux::database {

struct JournalLine {
  /// The uuid of the directory that the person is of.
  std::string directory;
  PersonId person;
  bool with_recordings = false;
  std::string erased_utc;

  friend bool operator==(const JournalLine&, const JournalLine&) = default;
};

/// Where the journal lies in a folder of backups.
std::filesystem::path journal_in(const std::filesystem::path& backups);

/// Oldest first; none where there is no file.
/// errors  DatabaseError: Damaged naming the line that was altered; BadInput where the file is a
///         link or too large
std::vector<JournalLine> read_journal(const std::filesystem::path& file);

/// Adds what is not there yet; on the disk when it returns.
/// errors  DatabaseError: as read_journal; storage failures, and then nothing was added
void add_to_journal(const std::filesystem::path& file, std::span<const JournalLine> lines);

}  // namespace hallux::database
