#include "database/recording/stored_chunks.h"

#include <algorithm>
#include <string>

#include "database/recording/recorder.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

std::string_view name_of(Stream stream) noexcept {
  if (stream == Stream::Tape) return "tape";
  return stream == Stream::Sample ? "samples" : "events";
}

StoredChunk chunk_in(SQLite::Statement& row) {
  StoredChunk chunk;
  ChunkPlace& place = chunk.place;
  read_columns(row, 0, chunk.number, place.stream, place.seq, place.first_tick, place.row_count);
  const SQLite::Column bytes = row.getColumn(5);
  const auto* const first = static_cast<const std::byte*>(bytes.getBlob());
  chunk.bytes.assign(first, first + bytes.getBytes());
  read_columns(row, 6, chunk.link);
  return chunk;
}

/// One number that a query about an attempt answers with.
std::optional<std::int64_t> number_of(Database& database, const char* sql, const AttemptId& id,
                                      std::int64_t bound) {
  return single<std::optional<std::int64_t>>(database, sql, id, bound);
}

/// The last window of which a row stands before `end_tick`; first ticks rise with the windows in
/// each stream.
std::optional<std::int64_t> last_window_before(Database& database, const AttemptId& id,
                                               std::int64_t end_tick) {
  return number_of(
      database,
      "SELECT max((SELECT c.seq FROM chunk c WHERE c.attempt_id = a.attempt_id AND c.stream = "
      "s.column1 AND c.first_tick < ?2 ORDER BY c.first_tick DESC LIMIT 1)) FROM attempt a, "
      "(VALUES (0), (1), (2)) s WHERE a.uuid = ?1",
      id, end_tick);
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
  return found<Digest>(database,
                       "SELECT c.link FROM attempt a JOIN chunk c USING (attempt_id) WHERE a.uuid "
                       "= ? AND c.seq < ? "
                       "ORDER BY c.seq DESC, c.stream DESC LIMIT 1",
                       id, window)
      .value_or(Digest{});
}

ChunkShape shape_of(const StoredChunk& chunk) noexcept {
  return {chunk.place.stream, static_cast<std::size_t>(chunk.place.row_count)};
}

ChunkWalk::ChunkWalk(Database& database, const AttemptId& id, const WindowRange& windows)
    : database_(&database),
      attempt_(id),
      rows_(std::make_unique<PreparedStatement>(
          prepared(database,
                   "SELECT c.chunk_id, c.stream, c.seq, c.first_tick, c.row_count, c.bytes, c.link "
                   "FROM attempt a JOIN chunk c USING (attempt_id) WHERE a.uuid = ? AND c.seq >= ? "
                   "AND c.seq < ? ORDER BY c.seq, c.stream",
                   id, windows.first, windows.end))) {}
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
  unpacker_.unpack(chunk.bytes, shape_of(chunk), tape, columns_);
  return columns_;
}

const Columns& ChunkReader::read_checked(const StoredChunk& chunk, const Columns* tape,
                                         const Digest& before) {
  read(chunk, tape);
  check(chunk, columns_, before);
  return columns_;
}

void ChunkReader::check(const StoredChunk& chunk, const Columns& columns, const Digest& before) {
  if (link_of(before, attempt_, chunk.place, payload_in(payload_, columns)) == chunk.link) return;
  fail_damaged("its link does not fit the chain");
}

}  // namespace hallux::database
