/// Any bytes read as a chunk of either format and any stream.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "database/recording/chunk_codec.h"

namespace hallux::database {

template <typename Row>
void read_rows(const Columns& columns) {
  std::vector<Row> rows;
  append_rows(columns, rows);
}

/// Whatever the bytes, it returns or throws DatabaseError.
inline void read_any_chunk(std::span<const std::byte> bytes) {
  if (bytes.size() < 2) return;
  const auto stream = static_cast<Stream>(static_cast<int>(bytes[0]) % 3);
  const ChunkShape shape{stream, static_cast<std::size_t>(bytes[1]) * 4};
  Columns tape{simulator::tape_columns, shape.row_count};
  Columns columns;
  ChunkUnpacker{}.unpack(bytes.subspan(2), shape, &tape, columns);
  if (stream == Stream::Tape) read_rows<simulator::TapeLine>(columns);
  if (stream == Stream::Sample) read_rows<simulator::ToolSample>(columns);
  if (stream == Stream::Event) read_rows<simulator::CutEvent>(columns);
}

}  // namespace hallux::database
