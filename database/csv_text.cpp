#include "database/csv_text.h"

namespace hallux::database {

std::string csv_cell(std::string_view text, bool is_number) {
  constexpr std::string_view starts_a_formula = "=+-@\t\r\n";
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

}  // namespace hallux::database
