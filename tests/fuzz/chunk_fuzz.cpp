/// Feeds any bytes to the chunk reader: it must return or throw DatabaseError.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "database/recording/chunk_codec.h"
#include "database/recording/column_coding.h"
#include "tests/database/recording/any_chunk.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto input = std::as_bytes(std::span{bytes, size});
  try {
    hallux::database::read_any_chunk(input);
  } catch (const hallux::database::DatabaseError&) {
  }
  // zstd's checksum keeps a fuzzer out: both contents are read on their own as well.
  const std::size_t row_count =
      std::clamp<std::size_t>(size / hallux::simulator::sample_columns, 1, 4096);
  hallux::database::Columns columns{hallux::simulator::sample_columns, row_count};
  const hallux::database::Columns tape{hallux::simulator::tape_columns, row_count};
  std::vector<hallux::simulator::ToolSample> samples;
  try {
    hallux::database::read_payload(input, columns);
    hallux::database::append_rows(columns, samples);
  } catch (const hallux::database::DatabaseError&) {
  }
  try {
    hallux::database::read_coded(input, &tape, columns);
    hallux::database::append_rows(columns, samples);
  } catch (const hallux::database::DatabaseError&) {
  }
  return 0;
}
