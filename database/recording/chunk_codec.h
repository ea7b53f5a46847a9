/// Codec of chunks: rows of the record as bytes and back, without loss. Inside this corner only.
///
///   bytes = format (1 byte), one zstd frame with content size and checksum whose content is
///           format 1: the payload itself (database/recording/columns.h)
///           format 2: the columns as coded (database/recording/column_coding.h)
///
/// The smaller of the two is written; format 1 alone is what programs wrote before, and is read for
/// ever. The hash chain is taken over the payload, so it does not matter to what was sealed in
/// which format a chunk is kept.
/// source  docs/data_format.md; measured in tests/benchmarks/record
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "database/recording/columns.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace hallux::database {

enum class Stream : std::int32_t { Tape = 0, Sample = 1, Event = 2 };

/// 0 for a number that is none of the streams.
std::size_t columns_in(Stream stream) noexcept;

/// Packs columns into chunk bytes; keeps the compressor's memory between calls.
/// thread  one at a time
class ChunkPacker {
 public:
  ChunkPacker();
  ChunkPacker(ChunkPacker&&) noexcept;
  ChunkPacker& operator=(ChunkPacker&&) noexcept;
  ~ChunkPacker();
  /// needs   at least one row; `payload` is that of the columns; `tape`, where there is one, is
  ///         what the chunk of the tape in the same window holds
  std::vector<std::byte> pack(const Columns& columns, std::span<const std::byte> payload,
                              const Columns* tape = nullptr);

 private:
  std::vector<std::byte> framed(std::byte format, std::span<const std::byte> content);

  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> context_;
  std::vector<std::byte> content_;
};

/// What chunk bytes claim to hold.
struct ChunkShape {
  Stream stream = Stream::Tape;
  std::size_t row_count = 0;
};

/// Reads chunk bytes; keeps its memory between calls.
/// thread  one at a time
class ChunkUnpacker {
 public:
  ChunkUnpacker();
  ChunkUnpacker(ChunkUnpacker&&) noexcept;
  ChunkUnpacker& operator=(ChunkUnpacker&&) noexcept;
  ~ChunkUnpacker();
  /// Reads `bytes` into `columns`. `tape`: what the chunk of the tape in the same window holds,
  /// where there is one.
  /// errors  DatabaseError Damaged: unknown format, not one whole frame, checksum, not exactly as
  ///         many rows as claimed
  void unpack(std::span<const std::byte> bytes, const ChunkShape& shape, const Columns* tape,
              Columns& columns);

 private:
  std::unique_ptr<ZSTD_DCtx_s, std::size_t (*)(ZSTD_DCtx_s*)> context_;
  std::vector<std::byte> content_;
};

/// False for format 1, which does not look at the tape.
bool may_need_tape(std::span<const std::byte> bytes) noexcept;

}  // namespace hallux::database
