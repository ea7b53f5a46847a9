#include "database/chunk_codec.h"

#include <zstd.h>

#include <array>
#include <new>

#include "simulator/base/check.h"

namespace hallux::database {

namespace {

constexpr std::byte format_one{1};
constexpr int zstd_level = 3;
constexpr std::size_t varint_bytes_max = 10;

[[noreturn]] void fail_damaged(const char* what) {
  throw DatabaseError{DatabaseErrorKind::Damaged, what};
}

constexpr std::uint64_t zigzag(std::uint64_t difference) noexcept {
  return (difference << 1U) ^ (0 - (difference >> 63U));
}
constexpr std::uint64_t unzigzag(std::uint64_t value) noexcept {
  return (value >> 1U) ^ (0 - (value & 1U));
}

void append_varint(std::vector<std::byte>& bytes, std::uint64_t value) {
  while (value >= 0x80U) {
    bytes.push_back(static_cast<std::byte>((value & 0x7FU) | 0x80U));
    value >>= 7U;
  }
  bytes.push_back(static_cast<std::byte>(value));
}

/// Takes varints off a span and never reads past its end.
class VarintReader {
 public:
  explicit VarintReader(std::span<const std::byte> bytes) noexcept : rest_(bytes) {}

  std::uint64_t take() {
    // Most differences fit one byte: read those without the loop.
    if (!rest_.empty() && rest_[0] < std::byte{0x80}) {
      const auto small = static_cast<std::uint64_t>(rest_[0]);
      rest_ = rest_.subspan(1);
      return small;
    }
    std::uint64_t value = 0;
    for (unsigned i = 0; i < varint_bytes_max; ++i) {
      if (i >= rest_.size()) fail_damaged("a number is cut short");
      const auto byte = static_cast<std::uint64_t>(rest_[i]);
      if (i == 9 && byte > 1) fail_damaged("a number is longer than 64 bits");
      value |= (byte & 0x7FU) << (7U * i);
      if (byte >= 0x80U) continue;
      if (i > 0 && byte == 0) fail_damaged("a number is not in its shortest form");
      rest_ = rest_.subspan(i + 1);
      return value;
    }
    fail_damaged("a number has no end");
  }
  bool is_empty() const noexcept { return rest_.empty(); }

 private:
  std::span<const std::byte> rest_;
};

template <typename Row>
std::vector<std::byte> pack_columns(std::span<const Row> rows) {
  using Columns = decltype(simulator::columns_of(std::declval<const Row&>()));
  constexpr std::size_t column_count = std::tuple_size_v<Columns>;
  std::vector<Columns> table;
  table.reserve(rows.size());
  for (const Row& row : rows) table.push_back(simulator::columns_of(row));
  std::vector<std::byte> payload;
  payload.reserve(rows.size() * column_count * 2);
  for (std::size_t column = 0; column < column_count; ++column) {
    std::uint64_t before = 0;
    for (const Columns& row : table) {
      const auto value = static_cast<std::uint64_t>(row[column]);
      append_varint(payload, zigzag(value - before));
      before = value;
    }
  }
  return payload;
}

template <typename Row, typename Columns>
void unpack_columns(std::span<const std::byte> payload, std::size_t row_count,
                    Row (*row_from)(const Columns&) noexcept, std::vector<Row>& rows) {
  constexpr std::size_t column_count = std::tuple_size_v<Columns>;
  CHECK(row_count <= rows_per_chunk_max);
  // Each number takes a byte at least: refuses a false count before memory is taken for it.
  if (payload.size() < row_count * column_count) fail_damaged("it has fewer rows than it says");
  std::vector<Columns> table(row_count);
  VarintReader reader{payload};
  for (std::size_t column = 0; column < column_count; ++column) {
    std::uint64_t value = 0;
    for (Columns& row : table) {
      value += unzigzag(reader.take());
      row[column] = static_cast<std::int64_t>(value);
    }
  }
  if (!reader.is_empty()) fail_damaged("it has more bytes than rows");
  const std::size_t rows_before = rows.size();
  rows.reserve(rows_before + row_count);
  for (const Columns& columns : table) {
    rows.push_back(row_from(columns));
    if (simulator::columns_of(rows.back()) == columns) continue;
    rows.resize(rows_before);
    fail_damaged("a number does not fit its column");
  }
}

constexpr std::size_t columns_in(Stream stream) noexcept {
  if (stream == Stream::Tape) return simulator::tape_columns;
  return stream == Stream::Sample ? simulator::sample_columns : simulator::event_columns;
}

}  // namespace

std::vector<std::byte> payload_from(std::span<const simulator::TapeLine> rows) {
  return pack_columns(rows);
}
std::vector<std::byte> payload_from(std::span<const simulator::ToolSample> rows) {
  return pack_columns(rows);
}
std::vector<std::byte> payload_from(std::span<const simulator::CutEvent> rows) {
  return pack_columns(rows);
}

void append_rows(std::span<const std::byte> payload, std::size_t row_count,
                 std::vector<simulator::TapeLine>& rows) {
  unpack_columns(payload, row_count, &simulator::tape_line_from, rows);
}
void append_rows(std::span<const std::byte> payload, std::size_t row_count,
                 std::vector<simulator::ToolSample>& rows) {
  unpack_columns(payload, row_count, &simulator::tool_sample_from, rows);
}
void append_rows(std::span<const std::byte> payload, std::size_t row_count,
                 std::vector<simulator::CutEvent>& rows) {
  unpack_columns(payload, row_count, &simulator::cut_event_from, rows);
}

ChunkPacker::ChunkPacker() : context_(ZSTD_createCCtx(), &ZSTD_freeCCtx) {
  if (!context_) throw std::bad_alloc{};
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, zstd_level);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_checksumFlag, 1);
}
ChunkPacker::ChunkPacker(ChunkPacker&&) noexcept = default;
ChunkPacker& ChunkPacker::operator=(ChunkPacker&&) noexcept = default;
ChunkPacker::~ChunkPacker() = default;

std::vector<std::byte> ChunkPacker::pack(std::span<const std::byte> payload) {
  std::vector<std::byte> bytes(1 + ZSTD_compressBound(payload.size()));
  bytes[0] = format_one;
  const std::size_t used = ZSTD_compress2(context_.get(), bytes.data() + 1, bytes.size() - 1,
                                          payload.data(), payload.size());
  CHECK(ZSTD_isError(used) == 0);
  bytes.resize(1 + used);
  return bytes;
}

std::vector<std::byte> unpack_payload(std::span<const std::byte> bytes, Stream stream,
                                      std::size_t row_count) {
  if (bytes.empty() || bytes[0] != format_one) fail_damaged("its format is unknown");
  if (row_count > rows_per_chunk_max) fail_damaged("it says that it has too many rows");
  const std::span<const std::byte> frame = bytes.subspan(1);
  const std::size_t frame_bytes = ZSTD_findFrameCompressedSize(frame.data(), frame.size());
  if (ZSTD_isError(frame_bytes) != 0 || frame_bytes != frame.size()) {
    fail_damaged("it is not one whole zstd frame");
  }
  const unsigned long long payload_bytes = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (payload_bytes > row_count * columns_in(stream) * varint_bytes_max) {
    fail_damaged("it is larger than its rows can be, or does not say how large it is");
  }
  std::vector<std::byte> payload(payload_bytes);
  const std::size_t read =
      ZSTD_decompress(payload.data(), payload.size(), frame.data(), frame.size());
  if (ZSTD_isError(read) != 0 || read != payload.size()) {
    fail_damaged("its zstd frame cannot be read");
  }
  return payload;
}

void read_any_chunk(std::span<const std::byte> bytes) {
  if (bytes.size() < 2) return;
  const auto stream = static_cast<Stream>(static_cast<int>(bytes[0]) % 3);
  const std::size_t row_count = static_cast<std::size_t>(bytes[1]) * 4;
  const std::vector<std::byte> payload = unpack_payload(bytes.subspan(2), stream, row_count);
  simulator::Recording recording;
  if (stream == Stream::Tape) append_rows(payload, row_count, recording.tape);
  if (stream == Stream::Sample) append_rows(payload, row_count, recording.samples);
  if (stream == Stream::Event) append_rows(payload, row_count, recording.events);
}

}  // namespace hallux::database
