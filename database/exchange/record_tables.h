/// Tables of a recording: three of integers in CSV (RFC 4180, CR LF), written and read.
/// Inside this corner only.
///
///   window,tick_ms,...    the window says which chunk a row lies in: chunks, links and seal follow
///                         from the tables alone
///
/// Every cell is a decimal integer in its shortest form, so that the same recording gives the same
/// bytes, and no cell can be taken for a formula. Columns and units: docs/data_format.md,
/// "Exported".
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "database/exchange/exchange_file.h"
#include "database/recording/chain.h"
#include "simulator/record/record.h"

namespace hallux::database {

inline constexpr std::array<std::string_view, 3> record_table_names{"tape.csv", "samples.csv",
                                                                    "events.csv"};

/// No attempt has more rows in a table: an hour. What a reader takes memory for.
inline constexpr std::int64_t rows_per_table_max = 3'600'000;

/// Writes the tables of `recording`, cut into chunks as `places` says, which stand in the order of
/// the chain.
/// needs   `places` covers each stream's rows exactly
/// errors  DatabaseError
std::vector<ExchangeFile> write_record_tables(const std::filesystem::path& folder,
                                              const simulator::Recording& recording,
                                              const std::vector<ChunkPlace>& places);

struct ReadTables {
  simulator::Recording recording;
  /// In the order of the chain.
  std::vector<ChunkPlace> places;
};

/// Reads the three tables that `files` names.
/// ensures ticks rise within a stream, and every number is one that a recording of ours can hold
/// errors  DatabaseError BadInput naming file and line
ReadTables read_record_tables(const ForeignFolder& folder, const std::vector<ExchangeFile>& files);

/// The link after the last chunk; zeros where there is none.
Digest last_link_of(const AttemptId& attempt, const simulator::Recording& recording,
                    const std::vector<ChunkPlace>& places);

/// Calls `visit(place, rows)` for each chunk in the order of the chain; `rows` is a span of its
/// stream's type.
template <typename Visit>
void visit_chunks(const simulator::Recording& recording, const std::vector<ChunkPlace>& places,
                  Visit&& visit) {
  std::array<std::size_t, 3> first{};
  for (const ChunkPlace& place : places) {
    std::size_t& at = first[static_cast<std::size_t>(place.stream)];
    const auto count = static_cast<std::size_t>(place.row_count);
    if (place.stream == Stream::Tape) visit(place, std::span(recording.tape).subspan(at, count));
    if (place.stream == Stream::Sample) {
      visit(place, std::span(recording.samples).subspan(at, count));
    }
    if (place.stream == Stream::Event) visit(place, std::span(recording.events).subspan(at, count));
    at += count;
  }
}

}  // namespace hallux::database
