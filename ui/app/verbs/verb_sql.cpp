#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "database/reports/report_process.h"
#include "database/text/csv_text.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"

namespace hallux::ui {

namespace {

using database::Report;
using database::ReportCell;
using nlohmann::ordered_json;

struct SqlOptions {
  std::string statement;
  bool csv = false;
};

/// Nobody signs in to a data directory without people; else it is an administrator's.
Report answer_to(const VerbContext& context, const std::string& statement) {
  database::ReportProcess process;
  database::Database database = open_to_read(context);
  if (context.login.empty()) {
    if (auto house = database::OpenHouse::enter(database)) return house->report(statement, process);
  }
  return sign_in_administrator(context, database, "run reports").desk.report(statement, process);
}

std::string hex_of(const std::vector<std::byte>& bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += digits[static_cast<std::size_t>(byte >> 4U)];
    text += digits[static_cast<std::size_t>(byte & std::byte{15})];
  }
  return text;
}

/// The shortest text that reads back as the same number.
std::string text_of(double number) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), written.ptr};
}

/// Nothing for NULL.
std::string text_of(const ReportCell& cell) {
  if (const auto* const whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
  if (const auto* const number = std::get_if<double>(&cell)) return text_of(*number);
  if (const auto* const text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* const blob = std::get_if<std::vector<std::byte>>(&cell)) return hex_of(*blob);
  return "";
}

ordered_json json_of(const ReportCell& cell) {
  if (const auto* const whole = std::get_if<std::int64_t>(&cell)) return *whole;
  if (const auto* const number = std::get_if<double>(&cell)) return *number;
  if (std::holds_alternative<std::monostate>(cell)) return nullptr;
  return text_of(cell);
}

/// RFC 4180. A text that a spreadsheet would take for a formula gets an apostrophe before it.
std::string csv_of(const ReportCell& cell) {
  const std::string text = text_of(cell);
  const bool is_formula = std::holds_alternative<std::string>(cell) && !text.empty() &&
                          std::string_view{"=+-@\t\r"}.find(text[0]) != std::string::npos;
  return database::csv_cell(text, !is_formula);
}

/// What a terminal may show of a cell.
std::string shown_of(const ReportCell& cell) { return terminal_text(text_of(cell)); }

/// A line with the names of the columns, then one for each row.
void write_lines(std::ostream& out, const Report& report, const char* between, const char* end,
                 std::string (*written_of)(const ReportCell&)) {
  const auto write_line = [&](const auto& cells) {
    const char* before = "";
    for (const auto& cell : cells) {
      out << before << written_of(cell);
      before = between;
    }
    out << end;
  };
  write_line(report.columns);
  for (const auto& row : report.rows) write_line(row);
}

void write_as_json(std::ostream& out, const Report& report) {
  ordered_json rows = ordered_json::array();
  for (const auto& row : report.rows) {
    ordered_json cells = ordered_json::array();
    for (const ReportCell& cell : row) cells.push_back(json_of(cell));
    rows.push_back(std::move(cells));
  }
  write_json(out, ordered_json{{"columns", report.columns}, {"rows", std::move(rows)}});
}

ExitCode sql_on(const VerbContext& context, const SqlOptions& options) {
  if (context.json && options.csv) {
    throw VerbError(ExitCode::WrongUsage, "an answer is --json or --csv, not both");
  }
  const Report report = answer_to(context, options.statement);
  if (context.json) {
    write_as_json(context.out, report);
  } else if (options.csv) {
    write_lines(context.out, report, ",", "\r\n", csv_of);
  } else {
    write_lines(context.out, report, "\t", "\n", shown_of);
  }
  return ExitCode::Done;
}

}  // namespace

void add_sql_verb(CLI::App& app, VerbContext& context) {
  const auto options = std::make_shared<SqlOptions>();
  CLI::App* sql = app.add_subcommand(
      "sql", "answer one SELECT over what is kept, without names, secrets and free text");
  sql->add_option("statement", options->statement, "as \"SELECT count(*) FROM attempt\"")
      ->required();
  sql->add_flag("--csv", options->csv, "answer as CSV");
  choose(*sql, context, [&context, options] { return sql_on(context, *options); });
}

}  // namespace hallux::ui
