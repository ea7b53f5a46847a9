/// Feeds any bytes to the chunk reader: it must return or throw DatabaseError.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "database/chunk_codec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto input = std::as_bytes(std::span{bytes, size});
  try {
    hallux::database::read_any_chunk(input);
  } catch (const hallux::database::DatabaseError&) {
  }
  // zstd's checksum keeps a fuzzer out: the payload is read on its own as well.
  try {
    std::vector<hallux::simulator::ToolSample> samples;
    const std::size_t row_count =
        std::min(size / hallux::simulator::sample_columns, hallux::database::rows_per_chunk_max);
    hallux::database::append_rows(input, row_count, samples);
  } catch (const hallux::database::DatabaseError&) {
  }
  return 0;
}
