/// Recording file of a backup: the stored chunks of one closed attempt and its display facts,
/// written once. Inside this corner only.
///
///     "HALLUXR2"  uuid (36 characters)  number of chunks
///     for each chunk, in the order of the chain: seq, stream, first_tick, row_count, length,
///     bytes, link (32 bytes)
///     number of display facts, and the columns of each (simulator/record/display_fact.h)
///     BLAKE2b-256 of all that stands before (32 bytes)
///
/// "HALLUXR1" is the same without display facts, as it was written before there were any. Integers
/// have 8 bytes, little-endian. Later backups name the same file, so a backup costs what
/// is new.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "database/records/ids.h"
#include "database/store/connection.h"
#include "simulator/base/digest.h"

namespace hallux::database {

/// A recording that lies beside a backup.
struct BackedUpRecording {
  AttemptId attempt;
  std::int64_t bytes = 0;
  /// The last 32 bytes of the file.
  Digest digest;

  friend bool operator==(const BackedUpRecording&, const BackedUpRecording&) = default;
};

std::filesystem::path recording_file(const std::filesystem::path& backups,
                                     const AttemptId& attempt);

/// Recordings on their way into a folder of backups. Each file is whole or not there: many are
/// written under no final name, synced together and then named, because to sync each of some
/// thousand costs more than all the rest.
class NewRecordingFiles {
 public:
  explicit NewRecordingFiles(std::filesystem::path backups) : backups_(std::move(backups)) {}

  /// Writes the file unless it is there.
  /// needs   the attempt is sealed, and its chain was checked
  /// errors  DatabaseError: storage failures; BadInput where what is there is no recording of that
  ///         attempt
  BackedUpRecording add(Database& database, const AttemptId& attempt);
  /// All that were added stand under their names from now on, also after a power cut.
  void put_in_place();

 private:
  std::filesystem::path backups_;
  std::vector<std::filesystem::path> unnamed_;
  std::int64_t unnamed_bytes_ = 0;
};

/// Puts the chunks and display facts of the file into the database, which knows the attempt but not
/// its chunks, in one transaction.
/// errors  DatabaseError: NotFound; Damaged where the file is not what was kept; BadInput for a
///         link
void put_recording_back(Database& database, const BackedUpRecording& kept,
                        const std::filesystem::path& backups);

/// errors  DatabaseError Damaged: "FILE was altered or damaged: `reason`; take an older backup"
[[noreturn]] void fail_backup(const std::filesystem::path& file, const char* reason);

}  // namespace hallux::database
