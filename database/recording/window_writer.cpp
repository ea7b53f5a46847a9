#include "database/recording/window_writer.h"

#include <algorithm>
#include <chrono>

#include "database/recording/display_facts.h"
#include "database/store/sql.h"

namespace hallux::database {

WindowWriter::WindowWriter(Database database, AttemptId attempt)
    : database_(std::move(database)), attempt_(std::move(attempt)) {
  attempt_number_ = translating(database_, "look for attempt " + attempt_.text, [&] {
    auto row = prepared(database_, "SELECT attempt_id FROM attempt WHERE uuid = ?", attempt_.text);
    if (row.executeStep()) return row.getColumn(0).getInt64();
    throw DatabaseError{DatabaseErrorKind::NotFound, "there is no attempt " + attempt_.text +
                                                         " in " + database_.file().string()};
  });
}

void WindowWriter::commit(std::int64_t seq, const WindowRows& rows) {
  if (rows.tape.empty() && rows.samples.empty() && rows.events.empty() &&
      rows.display_facts.empty()) {
    return;
  }
  const Digest link_before = last_link_;
  const RecorderStatistics statistics_before = statistics_;
  const auto start = std::chrono::steady_clock::now();
  try {
    in_transaction(database_, "record half a second of attempt " + attempt_.text, [&] {
      const Columns tape = columns_from(std::span{rows.tape});
      insert_chunk(Stream::Tape, seq, tape, nullptr);
      insert_chunk(Stream::Sample, seq, columns_from(std::span{rows.samples}), &tape);
      insert_chunk(Stream::Event, seq, columns_from(std::span{rows.events}), nullptr);
      store_display_facts(database_, attempt_number_, rows.display_facts);
    });
  } catch (...) {
    insert_.reset();
    last_link_ = link_before;
    statistics_ = statistics_before;
    throw;
  }
  const std::chrono::duration<double> spent_s = std::chrono::steady_clock::now() - start;
  ++statistics_.commits;
  statistics_.samples += static_cast<std::int64_t>(rows.samples.size());
  statistics_.display_facts += static_cast<std::int64_t>(rows.display_facts.size());
  statistics_.commit_s += spent_s.count();
  statistics_.commit_max_s = std::max(statistics_.commit_max_s, spent_s.count());
}

void WindowWriter::insert_chunk(Stream stream, std::int64_t seq, const Columns& columns,
                                const Columns* tape) {
  if (columns.row_count() == 0) return;
  const std::span<const std::byte> payload = payload_in(payload_, columns);
  const std::vector<std::byte> bytes = packer_.pack(columns, payload, tape);
  const auto row_count = static_cast<std::int64_t>(columns.row_count());
  const ChunkPlace place{stream, seq, columns.column(0).front(), row_count};
  last_link_ = link_of(last_link_, attempt_, place, payload);
  if (!insert_) {
    insert_ = std::make_unique<SQLite::Statement>(
        database_.connection(),
        "INSERT INTO chunk (attempt_id, seq, stream, first_tick, row_count, bytes, link) VALUES "
        "(?, ?, ?, ?, ?, ?, ?)");
  }
  run_again(*insert_, attempt_number_, seq, static_cast<int>(stream), place.first_tick, row_count,
            bytes, last_link_);
  statistics_.bytes += static_cast<std::int64_t>(bytes.size());
  statistics_.rows += row_count;
  ++statistics_.chunks;
}

}  // namespace hallux::database
