#include "database/recording/chunk_codec.h"

#include <zstd.h>

#include <new>

#include "database/recording/column_coding.h"
#include "simulator/base/check.h"

namespace hallux::database {

namespace {

constexpr std::byte format_payload{1};
constexpr std::byte format_coded{2};
constexpr int payload_level = 3;
/// In a stream of bits zstd finds nothing more: it only checks it.
constexpr int coded_level = -5;
/// Of one number in either format: a varint, or 97 bits of Rice code.
constexpr std::size_t number_bytes_max = 13;
constexpr std::size_t noisy_row_bytes = 3;
constexpr std::size_t head_bytes_max = 1 + varint_bytes_max;

}  // namespace

std::size_t columns_in(Stream stream) noexcept {
  switch (stream) {
    case Stream::Tape:
      return simulator::tape_columns;
    case Stream::Sample:
      return simulator::sample_columns;
    case Stream::Event:
      return simulator::event_columns;
  }
  return 0;
}

ChunkPacker::ChunkPacker() : context_(ZSTD_createCCtx(), &ZSTD_freeCCtx) {
  if (!context_) throw std::bad_alloc{};
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_checksumFlag, 1);
}
ChunkPacker::ChunkPacker(ChunkPacker&&) noexcept = default;
ChunkPacker& ChunkPacker::operator=(ChunkPacker&&) noexcept = default;
ChunkPacker::~ChunkPacker() = default;

std::vector<std::byte> ChunkPacker::pack(const Columns& columns, std::span<const std::byte> payload,
                                         const Columns* tape) {
  content_.clear();
  append_coded(content_, columns, tape);
  std::vector<std::byte> bytes = framed(format_coded, content_);
  // Pauses and scripted hands repeat themselves, which zstd sees in a payload and not in a stream
  // of bits. A hand that trembles does not: there is no need to try.
  if (bytes.size() > noisy_row_bytes * columns.row_count()) return bytes;
  std::vector<std::byte> plain = framed(format_payload, payload);
  return plain.size() < bytes.size() ? plain : bytes;
}

std::vector<std::byte> ChunkPacker::framed(std::byte format, std::span<const std::byte> content) {
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel,
                         format == format_coded ? coded_level : payload_level);
  std::vector<std::byte> bytes(1 + ZSTD_compressBound(content.size()));
  bytes[0] = format;
  const std::size_t used = ZSTD_compress2(context_.get(), bytes.data() + 1, bytes.size() - 1,
                                          content.data(), content.size());
  CHECK(ZSTD_isError(used) == 0);
  bytes.resize(1 + used);
  return bytes;
}

ChunkUnpacker::ChunkUnpacker() : context_(ZSTD_createDCtx(), &ZSTD_freeDCtx) {
  if (!context_) throw std::bad_alloc{};
}
ChunkUnpacker::ChunkUnpacker(ChunkUnpacker&&) noexcept = default;
ChunkUnpacker& ChunkUnpacker::operator=(ChunkUnpacker&&) noexcept = default;
ChunkUnpacker::~ChunkUnpacker() = default;

void ChunkUnpacker::unpack(std::span<const std::byte> bytes, const ChunkShape& shape,
                           const Columns* tape, Columns& columns) {
  const bool is_coded = !bytes.empty() && bytes[0] == format_coded;
  if (bytes.empty() || (!is_coded && bytes[0] != format_payload)) {
    fail_damaged("its format is unknown");
  }
  if (shape.row_count > rows_per_chunk_max) fail_damaged("it says that it has too many rows");
  if (shape.row_count == 0) fail_damaged("it says that it has no rows");
  const std::span<const std::byte> frame = bytes.subspan(1);
  const std::size_t frame_bytes = ZSTD_findFrameCompressedSize(frame.data(), frame.size());
  if (ZSTD_isError(frame_bytes) != 0 || frame_bytes != frame.size()) {
    fail_damaged("it is not one whole zstd frame");
  }
  const std::size_t column_count = columns_in(shape.stream);
  const unsigned long long content_bytes = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (content_bytes > column_count * (shape.row_count * number_bytes_max + head_bytes_max)) {
    fail_damaged("it is larger than its rows can be, or does not say how large it is");
  }
  // Of a payload each number takes a byte at least: refuses a false count before memory is taken
  // for it. Coded columns may take no bits at all, so there the count itself is the bound.
  if (!is_coded && content_bytes < shape.row_count * column_count) {
    fail_damaged("it has fewer rows than it says");
  }
  if (content_.size() < content_bytes) content_.resize(content_bytes);
  const std::size_t read = ZSTD_decompressDCtx(context_.get(), content_.data(), content_bytes,
                                               frame.data(), frame.size());
  if (ZSTD_isError(read) != 0 || read != content_bytes) {
    fail_damaged("its zstd frame cannot be read");
  }
  columns.reshape(column_count, shape.row_count);
  const std::span<const std::byte> content{content_.data(), read};
  if (is_coded) return read_coded(content, tape, columns);
  read_payload(content, columns);
}

bool may_need_tape(std::span<const std::byte> bytes) noexcept {
  return !bytes.empty() && bytes[0] == format_coded;
}

}  // namespace hallux::database
