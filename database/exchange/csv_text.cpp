#include "database/exchange/csv_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hallux::database {

std::string csv_text(std::string_view text) {
  constexpr std::string_view dangerous = "=+-@'\t\r";
  std::string cell;
  if (!text.empty() && dangerous.find(text.front()) != std::string_view::npos) cell.push_back('\'');
  cell.append(text);
  if (cell.find_first_of("\",\r\n") == std::string::npos) return cell;
  std::string quoted{"\""};
  for (const char letter : cell) {
    if (letter == '"') quoted.push_back('"');
    quoted.push_back(letter);
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
