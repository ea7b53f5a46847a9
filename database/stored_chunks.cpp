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

/// Which streams a thread reads.
enum class Part { Tape, Others, All };

bool is_part(Stream stream, Part part) noexcept {
  return part == Part::All || (stream == Stream::Tape) == (part == Part::Tape);
}

void append_columns(Stream stream, const Columns& columns, simulator::Recording& recording) {
  if (stream == Stream::Tape) append_rows(columns, recording.tape);
  if (stream == Stream::Sample) append_rows(columns, recording.samples);
  if (stream == Stream::Event) append_rows(columns, recording.events);
}

/// Reads one part of a run; remembers the first chunk that does not fit.
class PartReader {
 public:
  PartReader(const AttemptId& id, const ChunkRun& run, Part part)
      : run_(run), part_(part), reader_(id), tape_reader_(id) {}

  std::optional<Failure> append_to(simulator::Recording& recording) {
    for (std::size_t i = 0; i < run_.chunks.size(); ++i) {
      if (!is_part(run_.chunks[i].place.stream, part_)) continue;
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
    const Columns* tape = chunk.place.stream == Stream::Sample ? tape_of(index) : nullptr;
    append_columns(chunk.place.stream, reader_.read_checked(chunk, tape, *before), recording);
  }
  const Columns* tape_of(std::size_t index) {
    if (index == 0 || !may_need_tape(run_.chunks[index].bytes)) return nullptr;
    const StoredChunk& tape = run_.chunks[index - 1];
    if (tape.place.stream != Stream::Tape || tape.place.seq != run_.chunks[index].place.seq) {
      return nullptr;
    }
    return &tape_reader_.read(tape, nullptr);
  }

  const ChunkRun& run_;
  Part part_;
  ChunkReader reader_, tape_reader_;
};

void reserve_for(const ChunkRun& run, simulator::Recording& recording) {
  std::array<std::size_t, 3> rows{};
  for (const StoredChunk& chunk : run.chunks) {
    // A false count takes no more memory than a true one may.
    const auto count = static_cast<std::size_t>(std::clamp<std::int64_t>(
        chunk.place.row_count, 0, static_cast<std::int64_t>(chunk.bytes.size()) * 64));
    rows[static_cast<std::size_t>(chunk.place.stream)] += count;
  }
  recording.tape.reserve(recording.tape.size() + rows[0]);
  recording.samples.reserve(recording.samples.size() + rows[1]);
  recording.events.reserve(recording.events.size() + rows[2]);
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
  reserve_for(run, recording);
  std::optional<Failure> failure;
  if (run.chunks.size() < chunks_for_two_threads) {
    failure = PartReader{id, run, Part::All}.append_to(recording);
  } else {
    std::optional<Failure> failure_of_tape;
    {
      const std::jthread other{[&] {
        failure_of_tape = PartReader{id, run, Part::Tape}.append_to(recording);
      }};
      failure = PartReader{id, run, Part::Others}.append_to(recording);
    }
    if (failure_of_tape && (!failure || failure_of_tape->index < failure->index)) {
      failure = std::move(failure_of_tape);
    }
  }
  if (failure) fail_chunk(database, id, run.chunks[failure->index], failure->reason);
}

}  // namespace hallux::database
