/// Columns of a chunk, which are its rows transposed, and their canonical payload.
/// Inside this corner only.
///
///   payload  = column 0 of all rows, column 1 of all rows, ... (the columns of
///              simulator/record/record.h)
///   a column = for each row the difference to the row before (the first to 0, modulo 2^64),
///              zigzag, then base-128 varint, low seven bits first, in as few bytes as can be
///
/// The payload is canonical: the same rows give the same payload, another payload means other rows.
/// The hash chain is taken over it, so it does not matter to what was sealed how the columns were
/// packed.
/// source  docs/data_format.md
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "database/store/database_error.h"
#include "simulator/record/record.h"

namespace hallux::database {

/// No chunk holds more rows: what a bounded reader may believe.
inline constexpr std::size_t rows_per_chunk_max = 65536;
inline constexpr std::size_t varint_bytes_max = 10;

class Columns {
 public:
  Columns() = default;
  Columns(std::size_t column_count, std::size_t row_count) { reshape(column_count, row_count); }

  /// Other measures; what the columns hold afterwards is to be written first.
  void reshape(std::size_t column_count, std::size_t row_count) {
    column_count_ = column_count;
    row_count_ = row_count;
    values_.resize(column_count * row_count);
    is_filled_.assign(column_count, false);
  }
  std::size_t column_count() const noexcept { return column_count_; }
  std::size_t row_count() const noexcept { return row_count_; }
  std::span<std::int64_t> column(std::size_t index) noexcept {
    is_filled_[index] = false;
    return std::span{values_}.subspan(index * row_count_, row_count_);
  }
  std::span<const std::int64_t> column(std::size_t index) const noexcept {
    return std::span{values_}.subspan(index * row_count_, row_count_);
  }
  /// One number in all rows.
  void fill(std::size_t index, std::int64_t value) noexcept {
    std::ranges::fill(column(index), value);
    is_filled_[index] = true;
  }
  /// Whether all rows hold the same number there: most columns of most chunks do.
  bool is_constant(std::size_t index) const noexcept {
    if (is_filled_[index]) return true;
    const std::span<const std::int64_t> values = column(index);
    return values.size() < 2 || std::memcmp(values.data(), values.data() + 1,
                                            values.size_bytes() - sizeof(std::int64_t)) == 0;
  }

 private:
  std::size_t column_count_ = 0, row_count_ = 0;
  std::vector<std::int64_t> values_;
  /// By fill, and not touched since: need not be looked at.
  std::vector<bool> is_filled_;
};

Columns columns_from(std::span<const simulator::TapeLine> rows);
Columns columns_from(std::span<const simulator::ToolSample> rows);
Columns columns_from(std::span<const simulator::CutEvent> rows);

/// Appends the rows that the columns mean.
/// needs   as many columns as such a row has
/// errors  DatabaseError Damaged where a number does not fit its column; then nothing is appended
void append_rows(const Columns& columns, std::vector<simulator::TapeLine>& rows);
void append_rows(const Columns& columns, std::vector<simulator::ToolSample>& rows);
void append_rows(const Columns& columns, std::vector<simulator::CutEvent>& rows);

/// The payload of the columns, written into `buffer`, which grows where it must; valid as long as
/// the buffer is let be.
std::span<const std::byte> payload_in(std::vector<std::byte>& buffer, const Columns& columns);

/// The columns that `payload` means, into `columns`, which says how many and how long.
/// errors  DatabaseError Damaged where the payload is not exactly that many numbers in their
///         shortest form
void read_payload(std::span<const std::byte> payload, Columns& columns);

constexpr std::uint64_t zigzag(std::uint64_t difference) noexcept {
  return (difference << 1U) ^ (0 - (difference >> 63U));
}
constexpr std::uint64_t unzigzag(std::uint64_t value) noexcept {
  return (value >> 1U) ^ (0 - (value & 1U));
}

/// Takes varints off a span and never reads past its end.
class VarintReader {
 public:
  explicit VarintReader(std::span<const std::byte> bytes) noexcept : rest_(bytes) {}
  /// errors  DatabaseError Damaged: cut short, longer than 64 bits, not in its shortest form
  std::uint64_t take() {
    // Most differences fit one byte: read those without the loop.
    if (rest_.empty() || rest_[0] >= std::byte{0x80}) return take_long();
    const auto small = static_cast<std::uint64_t>(rest_[0]);
    rest_ = rest_.subspan(1);
    return small;
  }
  std::byte take_byte();
  std::span<const std::byte> rest() const noexcept { return rest_; }

 private:
  std::uint64_t take_long();

  std::span<const std::byte> rest_;
};

/// Writes a varint at `at`, where there is room for varint_bytes_max; returns the place behind it.
inline std::byte* put_varint(std::byte* at, std::uint64_t value) noexcept {
  while (value >= 0x80U) {
    *at++ = static_cast<std::byte>((value & 0x7FU) | 0x80U);
    value >>= 7U;
  }
  *at++ = static_cast<std::byte>(value);
  return at;
}

[[noreturn]] void fail_damaged(const char* what);

}  // namespace hallux::database
