/// A table of measurements: printed for a reader, written as CSV for a program.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hallux::benchmarks {

/// A word, a number, or nothing where it was not measured.
using Cell = std::variant<std::monostate, std::string, double>;

struct Table {
  /// snake_case: the name of the CSV file.
  std::string name;
  /// One line above the table.
  std::string title;
  /// Unit last: "median ms".
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
  /// Lines below the table: what is deferred, what was refused.
  std::vector<std::string> notes;
};

/// Three significant digits; "-" for nothing.
std::string text_of(const Cell& cell);
/// As Markdown, so that a printed table can stand in a document as it is.
/// needs   each row has a cell for each column
void print_table(std::ostream& out, const Table& table);
/// Writes `name`.csv into the folder: every number with all its digits, notes as lines that begin
/// with #.
/// errors  std::runtime_error naming the file that could not be written
void write_csv(const std::filesystem::path& folder, const Table& table);
/// Writes text as a file.
/// errors  std::runtime_error naming the file that could not be written
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace hallux::benchmarks
