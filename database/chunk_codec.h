/// Rows of the record as bytes, without loss: column by column differences, varints, zstd.
///
///   bytes    = format (1 byte, now 1), one zstd frame with checksum whose content is the payload
///   payload  = column 0 of all rows, column 1 of all rows, ... (the columns of simulator/record/record.h)
///   a column = for each row the difference to the row before (the first to 0, modulo 2^64), zigzag, then base-128 varint,
///              low seven bits first, in as few bytes as can be
///
/// The payload is canonical: the same rows give the same payload, another payload means other rows. The hash chain is
/// taken over it, so neither the compressor nor its level matters to what was sealed.
/// source  docs/data_format.md; measured choice: 6 to 7 bytes a sample
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "database/database_error.h"
#include "simulator/record/record.h"

struct ZSTD_CCtx_s;

namespace hallux::database {

enum class Stream : std::int32_t { Tape = 0, Sample = 1, Event = 2 };

/// No chunk holds more rows: what a bounded reader may believe.
inline constexpr std::size_t rows_per_chunk_max = 65536;

std::vector<std::byte> payload_from(std::span<const simulator::TapeLine> rows);
std::vector<std::byte> payload_from(std::span<const simulator::ToolSample> rows);
std::vector<std::byte> payload_from(std::span<const simulator::CutEvent> rows);

/// Appends the rows that `payload` means.
/// needs   row_count <= rows_per_chunk_max
/// errors  DatabaseError Damaged where the payload is not exactly that many rows of that type; then nothing is appended
void append_rows(std::span<const std::byte> payload, std::size_t row_count,
                 std::vector<simulator::TapeLine>& rows);
void append_rows(std::span<const std::byte> payload, std::size_t row_count,
                 std::vector<simulator::ToolSample>& rows);
void append_rows(std::span<const std::byte> payload, std::size_t row_count,
                 std::vector<simulator::CutEvent>& rows);

/// Packs payloads into chunk bytes; keeps the compressor's memory between calls.
/// thread  one at a time
class ChunkPacker {
 public:
  ChunkPacker();
  ChunkPacker(ChunkPacker&&) noexcept;
  ChunkPacker& operator=(ChunkPacker&&) noexcept;
  ~ChunkPacker();
  std::vector<std::byte> pack(std::span<const std::byte> payload);

 private:
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> context_;
};

/// The payload in chunk bytes of a stream.
/// errors  DatabaseError Damaged: unknown format, not one whole frame, checksum, more than `row_count` rows could need
std::vector<std::byte> unpack_payload(std::span<const std::byte> bytes, Stream stream,
                                      std::size_t row_count);

/// Reads `bytes` as a chunk of any stream; for fuzzers: whatever the bytes, it returns or throws DatabaseError.
void read_any_chunk(std::span<const std::byte> bytes);

}  // namespace hallux::database
