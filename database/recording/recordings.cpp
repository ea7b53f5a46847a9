#include "database/recording/recordings.h"

#include <limits>
#include <utility>

#include "database/recording/attempts.h"
#include "database/recording/chunk_run.h"
#include "database/recording/columns.h"
#include "database/recording/erased_recordings.h"
#include "database/recording/stored_chunks.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr WindowRange all_windows{0, std::numeric_limits<std::int64_t>::max()};
constexpr std::int64_t windows_checked_at_once = 240;

void check_seal(const Database& database, const AttemptHeader& header, const Digest& last_link) {
  if (!header.seal) return;
  if (seal_form(last_link, header)) return;
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

/// needs   the chunks were read and checked
Digest last_link(const ChunkRun& run) {
  return run.chunks.empty() ? run.before : run.chunks.back().link.value_or(Digest{});
}

struct ReadRecording {
  simulator::Recording recording;
  /// From which it was read.
  std::vector<StoredChunk> chunks;
};

ReadRecording read_recording(Database& database, const AttemptId& id, RecordingPart part) {
  const AttemptHeader header = load_header(database, id);
  refuse_erased(database, header.id);
  return translating(database, "read attempt " + header.id.text, [&] {
    ReadRecording read;
    read.recording.engine = header.begun.engine;
    read.chunks = load_chunks(database, header.id, all_windows);
    const ChunkRun run{read.chunks, {}};
    append_run(database, header.id, run, part, read.recording);
    check_seal(database, header, last_link(run));
    return read;
  });
}

}  // namespace

simulator::Recording load_recording(Database& database, const AttemptId& id, RecordingPart part) {
  return read_recording(database, id, part).recording;
}

PackedRecording load_packed_recording(Database& database, const AttemptId& id) {
  ReadRecording read = read_recording(database, id, RecordingPart::Outputs);
  PackedRecording packed{std::move(read.recording), {}};
  for (StoredChunk& chunk : read.chunks) {
    if (chunk.place.stream == Stream::Tape)
      packed.tape.add(std::move(chunk.bytes), shape_of(chunk));
  }
  return packed;
}

std::int64_t RecordingCheck::check(const AttemptHeader& header) {
  if (const auto erased = erased_recording(database_, header.id)) {
    check_seal(database_, header, erased->last_link);
    return 0;
  }
  return translating(database_, "check attempt " + header.id.text,
                     [&] { return check_chunks(header); });
}

std::int64_t RecordingCheck::check_chunks(const AttemptHeader& header) {
  tapes_.turn_to(header.id);
  others_.turn_to(header.id);
  tape_ = nullptr;
  std::int64_t chunk_count = 0;
  Digest link;
  for (auto window = window_from(database_, header.id, 0); window;) {
    const WindowRange windows{*window, *window + windows_checked_at_once};
    {
      ChunkWalk walk{database_, header.id, windows};
      while (const auto chunk = walk.next()) {
        check_chunk(header.id, *chunk, link);
        link = chunk->link.value_or(Digest{});
        ++chunk_count;
      }
    }
    window = window_from(database_, header.id, windows.end);
  }
  check_seal(database_, header, link);
  return chunk_count;
}

void RecordingCheck::check_chunk(const AttemptId& id, const StoredChunk& chunk,
                                 const Digest& before) {
  try {
    check_rows(chunk, before);
  } catch (const std::exception& error) {
    fail_chunk(database_, id, chunk, error.what());
  }
}

void RecordingCheck::check_rows(const StoredChunk& chunk, const Digest& before) {
  const ChunkPlace& place = chunk.place;
  rows_.tape.clear();
  rows_.samples.clear();
  rows_.events.clear();
  if (place.stream == Stream::Tape) {
    tape_ = &tapes_.read_checked(chunk, nullptr, before);
    tape_window_ = place.seq;
    append_rows(*tape_, rows_.tape);
  } else if (place.stream == Stream::Sample) {
    const Columns* const tape = tape_window_ == place.seq ? tape_ : nullptr;
    append_rows(others_.read_checked(chunk, tape, before), rows_.samples);
  } else {
    append_rows(others_.read_checked(chunk, nullptr, before), rows_.events);
  }
}

}  // namespace hallux::database
