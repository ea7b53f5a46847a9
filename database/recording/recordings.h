/// Recordings read back, their chain checked link by link.
#pragma once

#include <cstdint>

#include "database/recording/packed_tape.h"
#include "database/recording/stored_chunks.h"
#include "database/records/attempt.h"
#include "database/store/connection.h"
#include "simulator/record/record.h"

namespace hallux::database {

/// All that was committed: of a closed attempt the whole, of an interrupted one up to its last
/// window.
/// errors  DatabaseError: NotFound, also where the recording was erased; Damaged naming the first
///         chunk whose bytes or link were altered, or the seal
simulator::Recording load_recording(Database& database, const AttemptId& id,
                                    RecordingPart part = RecordingPart::Whole);

/// What scoring needs of a recording: its outputs, and the tape as it is stored.
struct PackedRecording {
  simulator::Recording outputs;
  PackedTape tape;
};

/// The same recording; all of it is checked, the tape as well.
/// errors  as load_recording
PackedRecording load_packed_recording(Database& database, const AttemptId& id);

/// Checks recordings one after the other; keeps its memory between them.
/// thread  one at a time
class RecordingCheck {
 public:
  explicit RecordingCheck(Database& database) : database_(database) {}

  /// What load_recording does, but keeps no rows; returns the number of chunks. Of an erased one
  /// the seal is checked.
  /// errors  as load_recording
  std::int64_t check(const AttemptHeader& header);

 private:
  std::int64_t check_chunks(const AttemptHeader& header);
  void check_chunk(const AttemptId& id, const StoredChunk& chunk, const Digest& before);
  void check_rows(const StoredChunk& chunk, const Digest& before);

  Database& database_;
  ChunkReader tapes_, others_;
  /// The last tape, and its window.
  const Columns* tape_ = nullptr;
  std::int64_t tape_window_ = 0;
  /// Of one chunk: that they can be made is a part of the check.
  simulator::Recording rows_;
};

}  // namespace hallux::database
