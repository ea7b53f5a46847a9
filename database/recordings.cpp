#include "database/recordings.h"

#include "database/attempts.h"
#include "database/chain.h"
#include "database/erased_recordings.h"
#include "database/sql.h"

namespace hallux::database {

namespace {

struct StoredChunk {
  std::int64_t number = 0;
  ChunkPlace place;
  std::span<const std::byte> bytes;
  std::optional<Digest> link;
};

std::string_view name_of(Stream stream) noexcept {
  if (stream == Stream::Tape) return "tape";
  return stream == Stream::Sample ? "samples" : "events";
}

[[noreturn]] void fail_chunk(const Database& database, const AttemptId& id,
                             const StoredChunk& chunk, std::string_view reason) {
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      "chunk " + std::to_string(chunk.number) + " (" +
                          std::string{name_of(chunk.place.stream)} + " of window " +
                          std::to_string(chunk.place.seq) + " of attempt " + id.text + ") in " +
                          database.file().string() +
                          " was altered or damaged: " + std::string{reason} + "; restore a backup"};
}

StoredChunk chunk_in(SQLite::Statement& row) {
  StoredChunk chunk;
  chunk.number = row.getColumn(0).getInt64();
  chunk.place = {static_cast<Stream>(row.getColumn(1).getInt()), row.getColumn(2).getInt64(),
                 row.getColumn(3).getInt64(), row.getColumn(4).getInt64()};
  const SQLite::Column bytes = row.getColumn(5);
  chunk.bytes = {static_cast<const std::byte*>(bytes.getBlob()),
                 static_cast<std::size_t>(bytes.getBytes())};
  chunk.link = digest_in(row.getColumn(6));
  return chunk;
}

void append_payload(const StoredChunk& chunk, std::span<const std::byte> payload,
                    simulator::Recording& recording) {
  const auto row_count = static_cast<std::size_t>(chunk.place.row_count);
  switch (chunk.place.stream) {
    case Stream::Tape:
      return append_rows(payload, row_count, recording.tape);
    case Stream::Sample:
      return append_rows(payload, row_count, recording.samples);
    case Stream::Event:
      return append_rows(payload, row_count, recording.events);
  }
}

/// Calls `visit`, which may find the payload damaged, for each chunk in the order of the chain; returns the last link.
template <typename Visit>
Digest walk_chain(Database& database, const AttemptId& id, Visit&& visit) {
  SQLite::Statement rows{
      database.connection(),
      "SELECT c.chunk_id, c.stream, c.seq, c.first_tick, c.row_count, c.bytes, c.link FROM chunk c "
      "JOIN attempt a USING (attempt_id) WHERE a.uuid = ? ORDER BY c.seq, c.stream"};
  rows.bind(1, id.text);
  Digest link;
  while (rows.executeStep()) {
    const StoredChunk chunk = chunk_in(rows);
    std::vector<std::byte> payload;
    try {
      payload = unpack_payload(chunk.bytes, chunk.place.stream,
                               static_cast<std::size_t>(chunk.place.row_count));
      link = link_of(link, id, chunk.place, payload);
      visit(chunk, payload);
    } catch (const DatabaseError& error) {
      fail_chunk(database, id, chunk, error.what());
    }
    if (link != chunk.link) fail_chunk(database, id, chunk, "its link does not fit the chain");
  }
  return link;
}

void check_seal(const Database& database, const AttemptHeader& header, const Digest& last_link) {
  if (!header.seal) return;
  if (seal_of(last_link, header) == *header.seal) return;
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      "attempt " + header.id.text + " in " + database.file().string() +
                          " does not fit its seal: a fact of it was altered, or its last chunks "
                          "were taken away; restore a backup"};
}

void refuse_erased(Database& database, const AttemptId& id) {
  const auto erased = erased_recording(database, id);
  if (!erased) return;
  throw DatabaseError{DatabaseErrorKind::NotFound,
                      "the recording of attempt " + id.text + " in " + database.file().string() +
                          " was erased on " + erased->erased_utc + "; its score stays"};
}

}  // namespace

simulator::Recording load_recording(Database& database, const AttemptId& id) {
  const AttemptHeader header = load_header(database, id);
  refuse_erased(database, header.id);
  return translating(database, "read attempt " + header.id.text, [&] {
    simulator::Recording recording;
    recording.engine = header.begun.engine;
    const Digest last_link = walk_chain(
        database, header.id, [&](const StoredChunk& chunk, std::span<const std::byte> payload) {
          append_payload(chunk, payload, recording);
        });
    check_seal(database, header, last_link);
    return recording;
  });
}

std::int64_t check_recording(Database& database, const AttemptId& id) {
  const AttemptHeader header = load_header(database, id);
  if (const auto erased = erased_recording(database, header.id)) {
    check_seal(database, header, erased->last_link);
    return 0;
  }
  return translating(database, "check attempt " + header.id.text, [&] {
    std::int64_t chunk_count = 0;
    const Digest last_link = walk_chain(
        database, header.id, [&](const StoredChunk& chunk, std::span<const std::byte> payload) {
          simulator::Recording one_chunk;
          append_payload(chunk, payload, one_chunk);
          ++chunk_count;
        });
    check_seal(database, header, last_link);
    return chunk_count;
  });
}

}  // namespace hallux::database
