/// Stored chunks of an attempt: loaded, decoded, checked against their links.
/// Inside this room only.
///
/// The link of a chunk binds it to the one before, and every link is stored: so each chunk can be
/// checked by itself, in any order and on any thread, and all of them together are the chain.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "database/recording/chain.h"
#include "database/recording/chunk_codec.h"
#include "database/store/connection.h"
#include "simulator/record/record.h"

namespace hallux::database {

class PreparedStatement;

struct StoredChunk {
  /// Its row in the database.
  std::int64_t number = 0;
  ChunkPlace place;
  std::vector<std::byte> bytes;
  std::optional<Digest> link;
};

ChunkShape shape_of(const StoredChunk& chunk) noexcept;

/// Windows by their numbers, from `first` up to and not with `end`.
struct WindowRange {
  std::int64_t first = 0, end = 0;
};

/// In the order of the chain.
/// errors  DatabaseError
std::vector<StoredChunk> load_chunks(Database& database, const AttemptId& id,
                                     const WindowRange& windows);

/// Simulated milliseconds from the attempt's first tick: from `first` up to and not with `end`.
struct TickRange {
  std::int64_t first = 0, end = 0;
};

/// The first window from that number on; nothing where there is none.
std::optional<std::int64_t> window_from(Database& database, const AttemptId& id,
                                        std::int64_t first);
/// Those in which a row of these ticks may stand, and one more: a row never stands in an earlier
/// window than its last tick, but in older records a line of the tape stands by its first.
WindowRange windows_around(Database& database, const AttemptId& id, const TickRange& ticks);

/// Zeros before the first chunk, as in the chain: the link of the last chunk before a window.
Digest link_before(Database& database, const AttemptId& id, std::int64_t window);

/// Chunks one after the other in the order of the chain, each read when it is asked for.
class ChunkWalk {
 public:
  /// errors  DatabaseError
  ChunkWalk(Database& database, const AttemptId& id, const WindowRange& windows);
  ChunkWalk(ChunkWalk&&) noexcept;
  ChunkWalk& operator=(ChunkWalk&&) noexcept;
  ~ChunkWalk();
  /// Nothing after the last.
  /// errors  DatabaseError Damaged for a stream that is none
  std::optional<StoredChunk> next();

 private:
  Database* database_;
  AttemptId attempt_;
  std::unique_ptr<PreparedStatement> rows_;
};

/// Reads chunks of one attempt and checks their links.
/// thread  one at a time
class ChunkReader {
 public:
  ChunkReader() = default;
  explicit ChunkReader(AttemptId attempt) : attempt_(std::move(attempt)) {}

  /// Chunks of another attempt from now on.
  void turn_to(const AttemptId& attempt) { attempt_ = attempt; }

  /// What `chunk` holds, without a look at its link; valid until the next call.
  /// errors  DatabaseError Damaged
  const Columns& read(const StoredChunk& chunk, const Columns* tape);
  /// What it holds, checked against the stored link before it; valid until the next call.
  /// errors  DatabaseError Damaged
  const Columns& read_checked(const StoredChunk& chunk, const Columns* tape, const Digest& before);
  /// The check alone, of what `chunk` holds.
  /// errors  DatabaseError Damaged
  void check(const StoredChunk& chunk, const Columns& columns, const Digest& before);

 private:
  AttemptId attempt_;
  ChunkUnpacker unpacker_;
  Columns columns_;
  std::vector<std::byte> payload_;
};

[[noreturn]] void fail_chunk(const Database& database, const AttemptId& id,
                             const StoredChunk& chunk, std::string_view reason);

}  // namespace hallux::database
