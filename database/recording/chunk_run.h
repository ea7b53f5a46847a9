/// A run of stored chunks decoded to rows, on two threads. Inside this corner only.
#pragma once

#include <span>

#include "database/recording/stored_chunks.h"
#include "database/records/attempt.h"
#include "database/store/connection.h"
#include "simulator/record/record.h"

namespace hallux::database {

/// Chunks in the order of the chain, the first of which stands at the beginning of a window.
struct ChunkRun {
  std::span<const StoredChunk> chunks;
  /// The link before the first of them.
  Digest before;
};

/// The rows of the run, the links of all of them checked, appended to `recording`; of a long run on
/// two threads.
/// errors  DatabaseError Damaged naming the first chunk that does not fit
void append_run(const Database& database, const AttemptId& id, const ChunkRun& run,
                RecordingPart part, simulator::Recording& recording);

}  // namespace hallux::database
