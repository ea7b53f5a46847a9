#include "database/exchange/integer_line.h"

#include <array>
#include <charconv>

namespace hallux::database {

void append_integer(std::string& line, std::int64_t value) {
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  line.append(digits.data(), end);
}

void take_integers(const ForeignLines& lines, std::string_view line,
                   std::span<std::int64_t> numbers) {
  const char* at = line.data();
  const char* const end = line.data() + line.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ','))
      lines.refuse("it has not as many columns as its table");
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    const std::string_view cell{at, static_cast<std::size_t>(next - at)};
    const bool is_shortest = cell == "0" || (!cell.empty() && cell[cell[0] == '-' ? 1 : 0] != '0');
    if (error != std::errc{} || !is_shortest || cell == "-0") {
      lines.refuse("column " + std::to_string(i + 1) + " is not a whole number as we write it");
    }
    at = next;
  }
  if (at != end) lines.refuse("it has more in it than the columns of its table");
}

}  // namespace hallux::database
