/// A row has up to 24 numbers, most of which never change within half a second. So a row is made
/// once of those that stay, copied, and the few columns that vary are put in one after the other;
/// range checks look at the least and the greatest number of a column instead of at each row.
#include "database/recording/columns.h"

#include <algorithm>
#include <array>

#include "simulator/base/check.h"

namespace hallux::database {

namespace {

template <typename Row>
Columns turn(std::span<const Row> rows) {
  constexpr std::size_t column_count =
      std::tuple_size_v<decltype(simulator::columns_of(std::declval<const Row&>()))>;
  Columns columns{column_count, rows.size()};
  if (rows.empty()) return columns;
  std::int64_t* const first = columns.column(0).data();
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto values = simulator::columns_of(rows[row]);
    for (std::size_t i = 0; i < column_count; ++i) first[i * rows.size() + row] = values[i];
  }
  return columns;
}

template <typename Row, typename Values>
using RowFrom = Row (*)(const Values&) noexcept;

using simulator::CutEvent;
using simulator::QuantisedPose;
using simulator::TapeLine;
using simulator::ToolSample;

void put(QuantisedPose& pose, std::size_t part, std::int64_t value) noexcept {
  const auto number = static_cast<std::int32_t>(value);
  if (part < 3) {
    pose.translation_um[part] = number;
  } else {
    pose.rotation_micro[part - 3] = number;
  }
}

/// Puts a number into the field of its column; false for one that seldom changes, which a whole row
/// is made for.
bool put(TapeLine& line, std::size_t column, std::int64_t value) noexcept {
  if (column > 7) return false;
  if (column == 0) {
    line.tick = value;
  } else {
    put(line.device.world_from_handle, column - 1, value);
  }
  return true;
}
bool put(ToolSample& sample, std::size_t column, std::int64_t value) noexcept {
  if (column > 10) return false;
  if (column == 0) {
    sample.tick = value;
  } else if (column < 8) {
    put(sample.world_from_tool, column - 1, value);
  } else {
    sample.force_mn[column - 8] = static_cast<std::int32_t>(value);
  }
  return true;
}
bool put(CutEvent& /*event*/, std::size_t /*column*/, std::int64_t /*value*/) noexcept {
  return false;
}

/// A column of which not all rows are the same.
struct Varying {
  std::size_t index = 0;
  const std::int64_t* values = nullptr;
};

/// Each column takes an interval of numbers and none minds another, so that a row of the least
/// numbers and one of the greatest speak for all rows.
template <typename Row, typename Values>
void check_range(const Columns& columns, std::span<const Varying> varying,
                 RowFrom<Row, Values> row_from, const Values& first) {
  Values least = first;
  Values greatest = first;
  for (const Varying& column : varying) {
    const auto [low, high] = std::ranges::minmax(columns.column(column.index));
    least[column.index] = low;
    greatest[column.index] = high;
  }
  if (simulator::columns_of(row_from(least)) == least &&
      simulator::columns_of(row_from(greatest)) == greatest) {
    return;
  }
  fail_damaged("a number does not fit its column");
}

/// Fills the columns that vary into rows that hold all others already; false where it met one that
/// it cannot.
template <typename Row>
bool fill(std::span<Row> rows, std::span<const Varying> varying) noexcept {
  for (const Varying& column : varying) {
    const std::int64_t* value = column.values;
    for (Row& row : rows) {
      if (!put(row, column.index, *value++)) return false;
    }
  }
  return true;
}

template <typename Row, typename Values>
void append(const Columns& columns, RowFrom<Row, Values> row_from, std::vector<Row>& rows) {
  CHECK(columns.column_count() == std::tuple_size_v<Values>);
  if (columns.row_count() == 0) return;
  Values values{};
  std::array<Varying, std::tuple_size_v<Values>> found{};
  std::size_t found_count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = columns.column(i).front();
    if (!columns.is_constant(i)) found[found_count++] = {i, columns.column(i).data()};
  }
  const std::span<const Varying> varying{found.data(), found_count};
  check_range(columns, varying, row_from, values);
  const std::size_t rows_before = rows.size();
  rows.resize(rows_before + columns.row_count(), row_from(values));
  if (fill(std::span{rows}.subspan(rows_before), varying)) return;
  for (std::size_t row = 0; row < columns.row_count(); ++row) {
    for (const Varying& column : varying) values[column.index] = column.values[row];
    rows[rows_before + row] = row_from(values);
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
    if (columns.row_count() > 0 && columns.is_constant(i)) {
      at = put_varint(at, zigzag(static_cast<std::uint64_t>(columns.column(i).front())));
      at = std::fill_n(at, columns.row_count() - 1, std::byte{0});
      continue;
    }
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
