/// Writer of the chunks of one window, each linked to the one before, in one transaction.
/// Inside this corner only.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "database/recording/chain.h"
#include "database/recording/recorder.h"
#include "database/store/sql.h"
#include "simulator/record/display_fact.h"

namespace hallux::database {

/// The rows of one window, or of what is still to be cut into windows; and what was on the screen,
/// which is in no window and goes with the next that is committed.
struct WindowRows {
  std::vector<simulator::TapeLine> tape;
  std::vector<simulator::ToolSample> samples;
  std::vector<simulator::CutEvent> events;
  std::vector<simulator::DisplayFact> display_facts;
};

class WindowWriter {
 public:
  /// errors  DatabaseError NotFound where the attempt is not stored
  WindowWriter(Database database, AttemptId attempt);

  /// Commits the rows as the chunks of window `seq` in one transaction; nothing where there are no
  /// rows.
  /// needs   windows come in rising order; no stream has more than rows_per_chunk_max rows
  /// errors  DatabaseError: then nothing of this window is stored, and it may be tried again
  void commit(std::int64_t seq, const WindowRows& rows);

  Database& database() noexcept { return database_; }
  const AttemptId& attempt() const noexcept { return attempt_; }
  const Digest& last_link() const noexcept { return last_link_; }
  const RecorderStatistics& statistics() const noexcept { return statistics_; }

 private:
  void insert_chunk(Stream stream, std::int64_t seq, const Columns& columns, const Columns* tape);

  Database database_;
  AttemptId attempt_;
  std::int64_t attempt_number_ = 0;
  ChunkPacker packer_;
  std::vector<std::byte> payload_;
  std::unique_ptr<SQLite::Statement> insert_;
  Digest last_link_;
  RecorderStatistics statistics_;
};

}  // namespace hallux::database
