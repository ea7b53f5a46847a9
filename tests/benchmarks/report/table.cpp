#include "tests/benchmarks/report/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "simulator/base/check.h"

namespace hallux::benchmarks {

namespace {

std::string formatted(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string three_digits(double value) {
  const double size = std::abs(value);
  if (value == std::round(value) && size < 1e7) return formatted("%.0f", value);
  if (size >= 100.0) return formatted("%.0f", value);
  if (size >= 10.0) return formatted("%.1f", value);
  if (size >= 1.0) return formatted("%.2f", value);
  return formatted("%.3g", value);
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char letter : text)
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return result + "\"";
}

std::string csv_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return quoted(*text);
  if (const auto* value = std::get_if<double>(&cell)) return formatted("%.17g", *value);
  return "";
}

}  // namespace

std::string text_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* value = std::get_if<double>(&cell)) return three_digits(*value);
  return "-";
}

void print_table(std::ostream& out, const Table& table) {
  for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::size_t width = table.columns[column].size();
    for (const auto& row : table.rows) width = std::max(width, text_of(row.at(column)).size());
    widths.push_back(width);
  }
  const auto print_row = [&](const auto& text_at) {
    out << '|';
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string text = text_at(i);
      out << ' ' << text << std::string(widths[i] - text.size(), ' ') << " |";
    }
    out << '\n';
  };
  out << "\n### " << table.title << "\n\n";
  print_row([&](std::size_t i) { return table.columns[i]; });
  print_row([&](std::size_t i) { return std::string(widths[i], '-'); });
  for (const auto& row : table.rows) print_row([&](std::size_t i) { return text_of(row[i]); });
  if (!table.notes.empty()) out << '\n';
  for (const std::string& note : table.notes) out << "- " << note << '\n';
  out.flush();
}

void write_csv(const std::filesystem::path& folder, const Table& table) {
  std::ostringstream text;
  for (const std::string& note : table.notes) text << "# " << note << '\n';
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    text << (i == 0 ? "" : ",") << quoted(table.columns[i]);
  }
  text << '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text << (i == 0 ? "" : ",") << csv_of(row[i]);
    text << '\n';
  }
  write_text(folder / (table.name + ".csv"), text.str());
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": could not be written");
}

}  // namespace hallux::benchmarks
