#include "database/recording/recordings.h"

#include <limits>

#include "database/recording/attempts.h"
#include "database/recording/chunk_run.h"
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

}  // namespace

simulator::Recording load_recording(Database& database, const AttemptId& id) {
  const AttemptHeader header = load_header(database, id);
  refuse_erased(database, header.id);
  return translating(database, "read attempt " + header.id.text, [&] {
    simulator::Recording recording;
    recording.engine = header.begun.engine;
    const std::vector<StoredChunk> chunks = load_chunks(database, header.id, all_windows);
    const ChunkRun run{chunks, {}};
    append_run(database, header.id, run, recording);
    check_seal(database, header, last_link(run));
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
    Digest link;
    auto window = window_from(database, header.id, 0);
    while (window) {
      const WindowRange windows{*window, *window + windows_checked_at_once};
      const std::vector<StoredChunk> chunks = load_chunks(database, header.id, windows);
      const ChunkRun run{chunks, link};
      simulator::Recording some_windows;
      append_run(database, header.id, run, some_windows);
      link = last_link(run);
      chunk_count += static_cast<std::int64_t>(chunks.size());
      window = window_from(database, header.id, windows.end);
    }
    check_seal(database, header, link);
    return chunk_count;
  });
}

}  // namespace hallux::database
