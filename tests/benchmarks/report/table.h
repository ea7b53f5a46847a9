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
  std::string name;                  ///< snake_case: the name of the CSV file
  std::string title;                 ///< one line above the table
  std::vector<std::string> columns;  ///< unit last: "median ms"
  std::vector<std::vector<Cell>> rows;
  std::vector<std::string> notes;  ///< lines below the table: what is deferred, what was refused
};

/// Three significant digits; "-" for nothing.
std::string text_of(const Cell& cell);
/// As Markdown, so that a printed table can stand in a document as it is.
/// needs   each row has a cell for each column
void print_table(std::ostream& out, const Table& table);
/// Writes `name`.csv into the folder: every number with all its digits, notes as lines that begin with #.
/// errors  std::runtime_error naming the file that could not be written
void write_csv(const std::filesystem::path& folder, const Table& table);
/// Writes text as a file.
/// errors  std::runtime_error naming the file that could not be written
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace hallux::benchmarks
