#include "database/stored_chunks.h"

#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <thread>

#include "database/recorder.h"
#include "database/sql.h"

namespace hallux::database {

namespace {

/// A thread is not worth starting for less: a minute is unpacked in some milliseconds.
constexpr std::size_t chunks_for_two_threads = 64;

std::string_view name_of(Stream stream) noexcept {
  if (stream == Stream::Tape) return "tape";
  return stream == Stream::Sample ? "samples" : "events";
}

StoredChunk chunk_in(SQLite::Statement& row) {
  StoredChunk chunk;
  chunk.number = row.getColumn(0).getInt64();
  chunk.place = {static_cast<Stream>(row.getColumn(1).getInt()), row.getColumn(2).getInt64(),
                 row.getColumn(3).getInt64(), row.getColumn(4).getInt64()};
  const SQLite::Column bytes = row.getColumn(5);
  const auto* const first = static_cast<const std::byte*>(bytes.getBlob());
  chunk.bytes.assign(first, first + bytes.getBytes());
  chunk.link = digest_in(row.getColumn(6));
  return chunk;
}

/// One number that a query about an attempt answers with.
std::optional<std::int64_t> number_of(Database& database, const char* sql, const AttemptId& id,
                                      std::int64_t bound) {
  SQLite::Statement query{database.connection(), sql};
  query.bind(1, id.text);
  query.bind(2, bound);
  if (!query.executeStep() || query.getColumn(0).isNull()) return std::nullopt;
  return query.getColumn(0).getInt64();
}

/// The last window of which a row stands before `end_tick`; first ticks rise with the windows in each stream.
std::optional<std::int64_t> last_window_before(Database& database, const AttemptId& id,
                                               std::int64_t end_tick) {
  return number_of(
      database,
      "SELECT max((SELECT c.seq FROM chunk c WHERE c.attempt_id = a.attempt_id AND c.stream = "
      "s.column1 AND c.first_tick < ?2 ORDER BY c.first_tick DESC LIMIT 1)) FROM attempt a, "
      "(VALUES (0), (1), (2)) s WHERE a.uuid = ?1",
      id, end_tick);
}

struct Failure {
  std::size_t index = 0;
  std::string reason;
};

void append_columns(Stream stream, const Columns& columns, simulator::Recording& recording) {
  if (stream == Stream::Tape) append_rows(columns, recording.tape);
  if (stream == Stream::Sample) append_rows(columns, recording.samples);
  if (stream == Stream::Event) append_rows(columns, recording.events);
}

void reserve_for(std::span<const StoredChunk> chunks, simulator::Recording& recording) {
  std::array<std::size_t, 3> rows{};
  for (const StoredChunk& chunk : chunks) {
    // A false count takes no more memory than a true one may.
    const auto count = static_cast<std::size_t>(std::clamp<std::int64_t>(
        chunk.place.row_count, 0, static_cast<std::int64_t>(chunk.bytes.size()) * 64));
    rows[static_cast<std::size_t>(chunk.place.stream)] += count;
  }
  recording.tape.reserve(recording.tape.size() + rows[0]);
  recording.samples.reserve(recording.samples.size() + rows[1]);
  recording.events.reserve(recording.events.size() + rows[2]);
}

/// Chunks of a run, from `first` up to and not with `end`.
struct Part {
  std::size_t first = 0, end = 0;
};

/// Reads one part of a run; remembers the first chunk that does not fit.
class PartReader {
 public:
  /// needs   the part begins with a window
  PartReader(const AttemptId& id, const ChunkRun& run, const Part& part)
      : run_(run), part_(part), reader_(id), tape_reader_(id) {}

  std::optional<Failure> append_to(simulator::Recording& recording) {
    reserve_for(run_.chunks.subspan(part_.first, part_.end - part_.first), recording);
    for (std::size_t i = part_.first; i < part_.end; ++i) {
      try {
        read(i, recording);
      } catch (const std::exception& error) {
        return Failure{i, error.what()};
      }
    }
    return std::nullopt;
  }

 private:
  void read(std::size_t index, simulator::Recording& recording) {
    const StoredChunk& chunk = run_.chunks[index];
    std::optional<Digest> before = run_.before;
    if (index > 0) before = run_.chunks[index - 1].link;
    if (!before) fail_damaged("the link before it is none");
    const bool is_tape = chunk.place.stream == Stream::Tape;
    const Columns* tape = chunk.place.stream == Stream::Sample ? tape_of(index) : nullptr;
    const Columns& columns = (is_tape ? tape_reader_ : reader_).read_checked(chunk, tape, *before);
    if (is_tape) tape_columns_ = &columns;
    append_columns(chunk.place.stream, columns, recording);
  }
  /// The tape of the same window, which was read just before.
  const Columns* tape_of(std::size_t index) const noexcept {
    if (index == part_.first) return nullptr;
    const ChunkPlace& before = run_.chunks[index - 1].place;
    const bool is_there =
        before.stream == Stream::Tape && before.seq == run_.chunks[index].place.seq;
    return is_there ? tape_columns_ : nullptr;
  }

  const ChunkRun& run_;
  Part part_;
  ChunkReader reader_, tape_reader_;
  const Columns* tape_columns_ = nullptr;  ///< of the last tape read
};

/// The first chunk of the window in the middle, so that both halves begin with a window.
std::size_t middle_of(std::span<const StoredChunk> chunks) noexcept {
  std::size_t middle = chunks.size() / 2;
  while (middle < chunks.size() && chunks[middle].place.seq == chunks[middle - 1].place.seq) {
    ++middle;
  }
  return middle;
}

void append(const simulator::Recording& later, simulator::Recording& recording) {
  const std::jthread other{
      [&] { recording.tape.insert(recording.tape.end(), later.tape.begin(), later.tape.end()); }};
  recording.samples.insert(recording.samples.end(), later.samples.begin(), later.samples.end());
  recording.events.insert(recording.events.end(), later.events.begin(), later.events.end());
}

/// Each half on a thread.
std::optional<Failure> append_halves(const AttemptId& id, const ChunkRun& run,
                                     simulator::Recording& recording) {
  const std::size_t middle = middle_of(run.chunks);
  simulator::Recording later;
  std::optional<Failure> failure, failure_of_later;
  reserve_for(run.chunks, recording);
  {
    const std::jthread other{[&] {
      failure_of_later = PartReader{id, run, {middle, run.chunks.size()}}.append_to(later);
    }};
    failure = PartReader{id, run, {0, middle}}.append_to(recording);
  }
  if (failure) return failure;
  if (failure_of_later) return failure_of_later;
  append(later, recording);
  return std::nullopt;
}

}  // namespace

void fail_chunk(const Database& database, const AttemptId& id, const StoredChunk& chunk,
                std::string_view reason) {
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      "chunk " + std::to_string(chunk.number) + " (" +
                          std::string{name_of(chunk.place.stream)} + " of window " +
                          std::to_string(chunk.place.seq) + " of attempt " + id.text + ") in " +
                          database.file().string() +
                          " was altered or damaged: " + std::string{reason} + "; restore a backup"};
}

std::optional<std::int64_t> window_from(Database& database, const AttemptId& id,
                                        std::int64_t first) {
  return number_of(database,
                   "SELECT min(c.seq) FROM attempt a JOIN chunk c USING (attempt_id) WHERE a.uuid "
                   "= ? AND c.seq >= ?",
                   id, first);
}

WindowRange windows_around(Database& database, const AttemptId& id, const TickRange& ticks) {
  const std::int64_t first =
      std::max<std::int64_t>(std::max<std::int64_t>(ticks.first, 0) / window_ticks - 1, 0);
  const std::int64_t last = last_window_before(database, id, ticks.end).value_or(-1);
  return {first, std::max(last + 1, first)};
}

Digest link_before(Database& database, const AttemptId& id, std::int64_t window) {
  SQLite::Statement row{
      database.connection(),
      "SELECT c.link FROM attempt a JOIN chunk c USING (attempt_id) WHERE a.uuid = ? AND c.seq < ? "
      "ORDER BY c.seq DESC, c.stream DESC LIMIT 1"};
  row.bind(1, id.text);
  row.bind(2, window);
  if (!row.executeStep()) return {};
  return digest_in(row.getColumn(0)).value_or(Digest{});
}

ChunkWalk::ChunkWalk(Database& database, const AttemptId& id, const WindowRange& windows)
    : database_(&database),
      attempt_(id),
      rows_(std::make_unique<SQLite::Statement>(
          database.connection(),
          "SELECT c.chunk_id, c.stream, c.seq, c.first_tick, c.row_count, c.bytes, c.link FROM "
          "attempt a JOIN chunk c USING (attempt_id) WHERE a.uuid = ? AND c.seq >= ? AND c.seq < ? "
          "ORDER BY c.seq, c.stream")) {
  rows_->bind(1, id.text);
  rows_->bind(2, windows.first);
  rows_->bind(3, windows.end);
}
ChunkWalk::ChunkWalk(ChunkWalk&&) noexcept = default;
ChunkWalk& ChunkWalk::operator=(ChunkWalk&&) noexcept = default;
ChunkWalk::~ChunkWalk() = default;

std::optional<StoredChunk> ChunkWalk::next() {
  if (!rows_->executeStep()) return std::nullopt;
  StoredChunk chunk = chunk_in(*rows_);
  if (columns_in(chunk.place.stream) == 0) {
    fail_chunk(*database_, attempt_, chunk, "its stream is none of the three");
  }
  return chunk;
}

std::vector<StoredChunk> load_chunks(Database& database, const AttemptId& id,
                                     const WindowRange& windows) {
  ChunkWalk walk{database, id, windows};
  std::vector<StoredChunk> chunks;
  while (auto chunk = walk.next()) chunks.push_back(std::move(*chunk));
  return chunks;
}

const Columns& ChunkReader::read(const StoredChunk& chunk, const Columns* tape) {
  const ChunkShape shape{chunk.place.stream, static_cast<std::size_t>(chunk.place.row_count)};
  unpacker_.unpack(chunk.bytes, shape, tape, columns_);
  return columns_;
}

const Columns& ChunkReader::read_checked(const StoredChunk& chunk, const Columns* tape,
                                         const Digest& before) {
  read(chunk, tape);
  if (link_of(before, attempt_, chunk.place, payload_in(payload_, columns_)) != chunk.link) {
    fail_damaged("its link does not fit the chain");
  }
  return columns_;
}

void append_run(const Database& database, const AttemptId& id, const ChunkRun& run,
                simulator::Recording& recording) {
  const bool is_long = run.chunks.size() >= chunks_for_two_threads;
  const std::optional<Failure> failure =
      is_long ? append_halves(id, run, recording)
              : PartReader{id, run, {0, run.chunks.size()}}.append_to(recording);
  if (failure) fail_chunk(database, id, run.chunks[failure->index], failure->reason);
}

}  // namespace hallux::database
