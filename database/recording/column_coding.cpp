/// Writing: of each column every guess is tried; the cheapest by a histogram of bit widths is kept,
/// and its order is then counted exactly beside its neighbour. The bits of every order would be the
/// dearer way to the same choice.
///
/// Reading: the columns come from the last to the first, because a root needs the three columns
/// behind it.
#include "database/recording/column_coding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "database/recording/rice_bits.h"

namespace hallux::database {

namespace {

enum class Guess : std::uint8_t { Before = 0, Line = 1, Tape = 2, Root = 3 };

constexpr unsigned order_of_zeros = 63;
/// Tape and samples begin alike, with a tick and a pose: only there does the writer look for what
/// the two share.
constexpr std::size_t shared_columns = 8;
constexpr std::size_t real_part_column = 4;
constexpr std::int64_t unit_micro = 1'000'000;

struct Head {
  Guess guess = Guess::Before;
  unsigned order = order_of_zeros;
  std::uint64_t first_rest = 0;
};

constexpr std::uint64_t number_of(std::int64_t value) noexcept {
  return static_cast<std::uint64_t>(value);
}

std::uint64_t square_of_unit(std::int64_t part_micro) noexcept {
  // Larger is none of a unit quaternion; a root of nothing is guessed then.
  if (part_micro < -unit_micro || part_micro > unit_micro) return number_of(unit_micro) * 1000000U;
  return number_of(part_micro * part_micro);
}

/// Exact: four times the radicand is below 2^52, and a square root is rounded correctly.
std::uint64_t root_guess(std::int64_t x, std::int64_t y, std::int64_t z) noexcept {
  constexpr std::uint64_t whole = number_of(unit_micro) * 1000000U;
  const std::uint64_t squares = square_of_unit(x) + square_of_unit(y) + square_of_unit(z);
  if (squares >= whole) return 0;
  const auto twice_root =
      static_cast<std::uint64_t>(std::sqrt(static_cast<double>(4 * (whole - squares))));
  return (twice_root + 1) / 2;
}

std::uint64_t root_guess(const Columns& columns, std::size_t index, std::size_t row) noexcept {
  return root_guess(columns.column(index + 1)[row], columns.column(index + 2)[row],
                    columns.column(index + 3)[row]);
}

bool has_tape(const Columns* tape, const Columns& columns, std::size_t index) noexcept {
  return tape != nullptr && tape->row_count() == columns.row_count() &&
         index < tape->column_count();
}

/// What is left of each row after the guess, zigzag.
void find_rests(const Columns& columns, std::size_t index, Guess guess, const Columns* tape,
                std::vector<std::uint64_t>& rests) {
  const std::span<const std::int64_t> values = columns.column(index);
  const std::size_t rows = values.size();
  rests.resize(rows);
  std::uint64_t before = 0;
  std::uint64_t step = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const std::uint64_t value = number_of(values[i]);
    std::uint64_t guessed = before;
    if (guess == Guess::Line) guessed += step;
    if (guess == Guess::Root) guessed = root_guess(columns, index, i);
    if (guess == Guess::Tape) {
      const std::span<const std::int64_t> along = tape->column(index);
      guessed += number_of(along[i]) - (i > 0 ? number_of(along[i - 1]) : 0);
    }
    rests[i] = zigzag(value - guessed);
    step = i > 0 ? value - before : 0;
    before = value;
  }
}

std::uint64_t bits_taken(std::span<const std::uint64_t> rests, unsigned order) noexcept {
  std::uint64_t bits = rests.size() * (order + 1);
  for (const std::uint64_t rest : rests) {
    const std::uint64_t zeros = rest >> order;
    bits += zeros < rice_zeros_max ? zeros : rice_zeros_max + 64 - order;
  }
  return bits;
}

struct Choice {
  unsigned order = order_of_zeros;
  std::uint64_t bits = 0;
};

/// How many rests have how many bits: enough to judge an order by, and not led astray by one that
/// is far off.
using Widths = std::array<std::uint32_t, 65>;

Widths widths_of(std::span<const std::uint64_t> rests) noexcept {
  Widths widths{};
  for (const std::uint64_t rest : rests) ++widths[static_cast<std::size_t>(std::bit_width(rest))];
  return widths;
}

/// A number of `width` bits lies in the middle of its octave.
std::uint64_t bits_expected(const Widths& widths, unsigned order) noexcept {
  std::uint64_t bits = 0;
  for (unsigned width = 0; width < widths.size(); ++width) {
    if (widths[width] == 0) continue;
    const unsigned above = width > order ? width - order : 0;
    const std::uint64_t zeros = above == 0 ? 0 : above > 6 ? rice_zeros_max : (3U << above) / 4;
    const bool is_whole = zeros >= rice_zeros_max;
    bits += widths[width] * (is_whole ? rice_zeros_max + 65 : order + 1 + zeros);
  }
  return bits;
}

Choice choice_expected(const Widths& widths) noexcept {
  unsigned widest = 64;
  while (widest > 0 && widths[widest] == 0) --widest;
  if (widest == 0) return {};
  Choice best{0, bits_expected(widths, 0)};
  for (unsigned order = 1; order <= std::min(widest, rice_order_max); ++order) {
    const std::uint64_t bits = bits_expected(widths, order);
    if (bits < best.bits) best = {order, bits};
  }
  return best;
}

/// What was expected, weighed against its neighbour.
Choice best_order(std::span<const std::uint64_t> rests, const Choice& expected) noexcept {
  if (expected.order == order_of_zeros) return {};
  Choice best{expected.order, bits_taken(rests, expected.order)};
  if (best.order == 0) return best;
  const std::uint64_t bits = bits_taken(rests, best.order - 1);
  return bits < best.bits ? Choice{best.order - 1, bits} : best;
}

/// Chooses guesses and keeps what they leave, for one column after the other.
class ColumnCoder {
 public:
  ColumnCoder(const Columns& columns, const Columns* tape) noexcept
      : columns_(columns), tape_(tape) {}

  /// After it, `rests()` are those of the best guess, but for a column of one number only, which
  /// has none.
  Head choose(std::size_t index) {
    if (columns_.is_constant(index)) {
      return {Guess::Before, order_of_zeros, zigzag(number_of(columns_.column(index).front()))};
    }
    guess_.reset();
    consider(index, Guess::Before);
    if (index < shared_columns && has_tape(tape_, columns_, index)) consider(index, Guess::Tape);
    consider(index, Guess::Line);
    if (index == real_part_column) consider(index, Guess::Root);
    const Choice choice = best_order(std::span{rests_}.subspan(1), expected_);
    bits_ += choice.bits;
    return {*guess_, choice.order, rests_.front()};
  }
  std::span<const std::uint64_t> rests() const noexcept { return rests_; }
  /// Of all columns that were chosen for.
  std::uint64_t bits() const noexcept { return bits_; }

 private:
  void consider(std::size_t index, Guess guess) {
    if (guess_ && expected_.bits == 0) return;
    find_rests(columns_, index, guess, tape_, tried_);
    const Choice expected = choice_expected(widths_of(std::span{tried_}.subspan(1)));
    if (guess_ && expected.bits >= expected_.bits) return;
    guess_ = guess;
    expected_ = expected;
    rests_.swap(tried_);
  }

  const Columns& columns_;
  const Columns* tape_;
  std::optional<Guess> guess_;
  Choice expected_;
  std::uint64_t bits_ = 0;
  std::vector<std::uint64_t> rests_, tried_;
};

void add_rest(std::vector<std::byte>& coded, std::uint64_t rest) {
  std::array<std::byte, varint_bytes_max> bytes{};
  coded.insert(coded.end(), bytes.data(), put_varint(bytes.data(), rest));
}

Head take_head(VarintReader& reader, const Columns& columns, const Columns* tape,
               std::size_t index) {
  const auto byte = static_cast<unsigned>(reader.take_byte());
  Head head{static_cast<Guess>(byte >> 6U), byte & 63U, reader.take()};
  if (head.order > rice_order_max && head.order != order_of_zeros) {
    fail_damaged("an order is none of its code");
  }
  if (head.guess == Guess::Root && index + 3 >= columns.column_count()) {
    fail_damaged("a root has not three columns");
  }
  if (head.guess == Guess::Tape && !has_tape(tape, columns, index)) {
    fail_damaged("the tape of its window is missing or has not as many rows");
  }
  return head;
}

/// From rests to numbers, in place.
void add_guesses(Columns& columns, std::size_t index, Guess guess, const Columns* tape) {
  const std::span<std::int64_t> values = columns.column(index);
  std::uint64_t before = 0;
  std::uint64_t step = 0;
  const auto rest_of = [&](std::size_t i) { return unzigzag(number_of(values[i])); };
  if (guess == Guess::Before) {
    for (std::int64_t& value : values) {
      before += unzigzag(number_of(value));
      value = static_cast<std::int64_t>(before);
    }
  } else if (guess == Guess::Line) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::uint64_t value = before + step + rest_of(i);
      step = i > 0 ? value - before : 0;
      before = value;
      values[i] = static_cast<std::int64_t>(value);
    }
  } else if (guess == Guess::Tape) {
    const std::span<const std::int64_t> along = tape->column(index);
    std::uint64_t aside = 0;  // of the tape
    for (std::size_t i = 0; i < values.size(); ++i) {
      aside += rest_of(i);
      values[i] = static_cast<std::int64_t>(number_of(along[i]) + aside);
    }
  } else {
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<std::int64_t>(root_guess(columns, index, i) + rest_of(i));
    }
  }
}

}  // namespace

void append_coded(std::vector<std::byte>& coded, const Columns& columns, const Columns* tape) {
  ColumnCoder coder{columns, tape};
  std::vector<Head> heads(columns.column_count());
  std::vector<std::vector<std::uint64_t>> rests(columns.column_count());
  for (std::size_t index = 0; index < columns.column_count(); ++index) {
    heads[index] = coder.choose(index);
    if (heads[index].order != order_of_zeros) {
      rests[index].assign(coder.rests().begin() + 1, coder.rests().end());
    }
  }
  for (const Head& head : heads) {
    coded.push_back(static_cast<std::byte>((static_cast<unsigned>(head.guess) << 6U) | head.order));
    add_rest(coded, head.first_rest);
  }
  RiceWriter writer{coded, coder.bits()};
  for (std::size_t index = columns.column_count(); index-- > 0;) {
    for (const std::uint64_t rest : rests[index]) writer.put(rest, heads[index].order);
  }
  writer.finish();
}

void read_coded(std::span<const std::byte> coded, const Columns* tape, Columns& columns) {
  VarintReader reader{coded};
  std::vector<Head> heads;
  heads.reserve(columns.column_count());
  for (std::size_t index = 0; index < columns.column_count(); ++index) {
    heads.push_back(take_head(reader, columns, tape, index));
  }
  RiceReader bits{reader.rest()};
  for (std::size_t index = columns.column_count(); index-- > 0;) {
    if (heads[index].guess == Guess::Before && heads[index].order == order_of_zeros) {
      columns.fill(index, static_cast<std::int64_t>(unzigzag(heads[index].first_rest)));
      continue;
    }
    const std::span<std::int64_t> values = columns.column(index);
    values[0] = static_cast<std::int64_t>(heads[index].first_rest);
    if (heads[index].order == order_of_zeros) {
      std::fill(values.begin() + 1, values.end(), 0);
    } else {
      bits.take_all(heads[index].order, values.subspan(1));
    }
    add_guesses(columns, index, heads[index].guess, tape);
  }
  if (!bits.is_at_end()) fail_damaged("it has more bits than rows");
}

}  // namespace hallux::database
