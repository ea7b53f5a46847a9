#include "database/text/csv_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hallux::database {

std::string csv_cell(std::string_view text, bool is_number) {
  constexpr std::string_view starts_a_formula = "=+-@'\t\r\n";
  std::string cell;
  if (!is_number && !text.empty() &&
      starts_a_formula.find(text.front()) != std::string_view::npos) {
    cell = "'";
  }
  cell += text;
  if (cell.find_first_of("\",\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string csv_number(double value) {
  if (!std::isfinite(value)) return {};
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

}  // namespace hallux::database
