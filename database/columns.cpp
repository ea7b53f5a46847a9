#include "database/columns.h"

#include <algorithm>

#include "simulator/base/check.h"

namespace hallux::database {

namespace {

template <typename Row>
Columns turn(std::span<const Row> rows) {
  constexpr std::size_t column_count =
      std::tuple_size_v<decltype(simulator::columns_of(std::declval<const Row&>()))>;
  Columns columns{column_count, rows.size()};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto values = simulator::columns_of(rows[row]);
    for (std::size_t i = 0; i < column_count; ++i) columns.column(i)[row] = values[i];
  }
  return columns;
}

/// Each column takes an interval of numbers and none minds another, so that a row of the least numbers and one of the
/// greatest speak for all rows.
template <typename Row, typename Values>
void check_range(const Columns& columns, Row (*row_from)(const Values&) noexcept) {
  Values least{};
  Values greatest{};
  for (std::size_t i = 0; i < least.size(); ++i) {
    const auto [low, high] = std::ranges::minmax(columns.column(i));
    least[i] = low;
    greatest[i] = high;
  }
  if (simulator::columns_of(row_from(least)) == least &&
      simulator::columns_of(row_from(greatest)) == greatest) {
    return;
  }
  fail_damaged("a number does not fit its column");
}

template <typename Row, typename Values>
void append(const Columns& columns, Row (*row_from)(const Values&) noexcept,
            std::vector<Row>& rows) {
  CHECK(columns.column_count() == std::tuple_size_v<Values>);
  if (columns.row_count() == 0) return;
  check_range(columns, row_from);
  Values values{};
  for (std::size_t row = 0; row < columns.row_count(); ++row) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = columns.column(i)[row];
    rows.push_back(row_from(values));
  }
}

}  // namespace

void fail_damaged(const char* what) { throw DatabaseError{DatabaseErrorKind::Damaged, what}; }

std::uint64_t VarintReader::take_long() {
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

std::byte VarintReader::take_byte() {
  if (rest_.empty()) fail_damaged("it is cut short");
  const std::byte byte = rest_[0];
  rest_ = rest_.subspan(1);
  return byte;
}

Columns columns_from(std::span<const simulator::TapeLine> rows) { return turn(rows); }
Columns columns_from(std::span<const simulator::ToolSample> rows) { return turn(rows); }
Columns columns_from(std::span<const simulator::CutEvent> rows) { return turn(rows); }

void append_rows(const Columns& columns, std::vector<simulator::TapeLine>& rows) {
  append(columns, &simulator::tape_line_from, rows);
}
void append_rows(const Columns& columns, std::vector<simulator::ToolSample>& rows) {
  append(columns, &simulator::tool_sample_from, rows);
}
void append_rows(const Columns& columns, std::vector<simulator::CutEvent>& rows) {
  append(columns, &simulator::cut_event_from, rows);
}

std::span<const std::byte> payload_in(std::vector<std::byte>& buffer, const Columns& columns) {
  const std::size_t bytes_max = columns.column_count() * columns.row_count() * varint_bytes_max;
  if (buffer.size() < bytes_max) buffer.resize(bytes_max);
  std::byte* at = buffer.data();
  for (std::size_t i = 0; i < columns.column_count(); ++i) {
    std::uint64_t before = 0;
    for (const std::int64_t value : columns.column(i)) {
      at = put_varint(at, zigzag(static_cast<std::uint64_t>(value) - before));
      before = static_cast<std::uint64_t>(value);
    }
  }
  return {buffer.data(), at};
}

void read_payload(std::span<const std::byte> payload, Columns& columns) {
  VarintReader reader{payload};
  for (std::size_t i = 0; i < columns.column_count(); ++i) {
    std::uint64_t value = 0;
    for (std::int64_t& number : columns.column(i)) {
      value += unzigzag(reader.take());
      number = static_cast<std::int64_t>(value);
    }
  }
  if (!reader.rest().empty()) fail_damaged("it has more bytes than rows");
}

}  // namespace hallux::database
