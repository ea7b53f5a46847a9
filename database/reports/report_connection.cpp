/// Four bounds, each for what the others let pass: a connection that cannot write, an authorizer
/// that decides about each column, SQLite's limits on the statement, and a deadline that is looked
/// at every thousand steps. Rows are counted while they come: a report that is too large ends, it
/// is not cut.
#include "database/reports/report_connection.h"

#include <sqlite3.h>

#include <array>
#include <chrono>

#include "database/reports/report_access.h"
#include "database/reports/virtual_tables.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr int operations_between_looks = 1000;
constexpr std::size_t statement_bytes_max = 100'000;

struct Limit {
  int what;
  int value;
};
/// An asset or a chunk is read as a whole; all else is far below.
constexpr std::array sqlite_limits{Limit{SQLITE_LIMIT_LENGTH, 32 << 20},
                                   Limit{SQLITE_LIMIT_SQL_LENGTH, 100'000},
                                   Limit{SQLITE_LIMIT_COLUMN, 200},
                                   Limit{SQLITE_LIMIT_EXPR_DEPTH, 100},
                                   Limit{SQLITE_LIMIT_COMPOUND_SELECT, 20},
                                   Limit{SQLITE_LIMIT_VDBE_OP, 50'000},
                                   Limit{SQLITE_LIMIT_FUNCTION_ARG, 20},
                                   Limit{SQLITE_LIMIT_ATTACHED, 0},
                                   Limit{SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 200},
                                   Limit{SQLITE_LIMIT_VARIABLE_NUMBER, 20},
                                   Limit{SQLITE_LIMIT_TRIGGER_DEPTH, 1},
                                   Limit{SQLITE_LIMIT_WORKER_THREADS, 0}};

std::unique_ptr<Database> opened(const std::filesystem::path& directory) {
  OpenOptions options;
  options.access = Access::ReadOnly;
  return std::make_unique<Database>(Database::open(directory, options));
}

/// Stops the statement of a connection once its time is over.
class Deadline {
 public:
  Deadline(sqlite3* connection, int time_ms)
      : connection_(connection), end_(Clock::now() + std::chrono::milliseconds(time_ms)) {
    sqlite3_progress_handler(connection_, operations_between_looks, &Deadline::is_over, this);
  }
  ~Deadline() { sqlite3_progress_handler(connection_, 0, nullptr, nullptr); }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  static int is_over(void* self) noexcept {
    return Clock::now() > static_cast<const Deadline*>(self)->end_ ? 1 : 0;
  }

  sqlite3* connection_;
  Clock::time_point end_;
};

struct Finalizer {
  void operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }
};
using StatementPtr = std::unique_ptr<sqlite3_stmt, Finalizer>;

[[noreturn]] void fail(DatabaseErrorKind kind, const std::string& reason) {
  throw DatabaseError{kind, "could not answer the report: " + reason};
}

[[noreturn]] void fail_as_sqlite(sqlite3* connection, const ReportLimits& limits) {
  const std::string text = sqlite3_errmsg(connection);
  // Of a function that the authorizer denies SQLite says no more than this.
  if (text.starts_with("not authorized")) fail(DatabaseErrorKind::Refused, text);
  switch (sqlite3_errcode(connection)) {
    case SQLITE_AUTH:
      fail(DatabaseErrorKind::Refused,
           text + "; a report reads tables, but no names, secrets and free text");
    case SQLITE_INTERRUPT:
      fail(DatabaseErrorKind::BadInput, "it took longer than " + std::to_string(limits.time_ms) +
                                            " ms; ask for less, as with a range of `tick`");
    case SQLITE_CORRUPT:
      fail(DatabaseErrorKind::Damaged, text);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      fail(DatabaseErrorKind::Locked, text + "; try again");
    case SQLITE_IOERR:
      fail(DatabaseErrorKind::InputOutput, text);
    default:
      fail(DatabaseErrorKind::BadInput, text);
  }
}

StatementPtr prepared(sqlite3* connection, const std::string& sql, const ReportLimits& limits) {
  if (sql.size() > statement_bytes_max) {
    fail(DatabaseErrorKind::BadInput, "the statement is longer than 100000 bytes");
  }
  if (sql.find('\0') != std::string::npos) {
    fail(DatabaseErrorKind::BadInput, "the statement holds a zero byte");
  }
  sqlite3_stmt* made = nullptr;
  const char* rest = nullptr;
  const int code = sqlite3_prepare_v2(connection, sql.c_str(), -1, &made, &rest);
  StatementPtr statement{made};
  if (code != SQLITE_OK) fail_as_sqlite(connection, limits);
  if (!statement) fail(DatabaseErrorKind::BadInput, "there is no statement in it");
  if (std::string_view{rest}.find_first_not_of(" \t\r\n;") != std::string_view::npos) {
    fail(DatabaseErrorKind::BadInput, "it is more than one statement");
  }
  if (sqlite3_stmt_readonly(statement.get()) == 0 || sqlite3_column_count(statement.get()) == 0) {
    fail(DatabaseErrorKind::Refused, "it is no SELECT");
  }
  return statement;
}

ReportCell cell_of(sqlite3_stmt* row, int column) {
  switch (sqlite3_column_type(row, column)) {
    case SQLITE_INTEGER:
      return static_cast<std::int64_t>(sqlite3_column_int64(row, column));
    case SQLITE_FLOAT:
      return sqlite3_column_double(row, column);
    case SQLITE_TEXT: {
      const auto* const text = static_cast<const void*>(sqlite3_column_text(row, column));
      return std::string{static_cast<const char*>(text),
                         static_cast<std::size_t>(sqlite3_column_bytes(row, column))};
    }
    case SQLITE_BLOB: {
      const auto* const bytes = static_cast<const std::byte*>(sqlite3_column_blob(row, column));
      return std::vector<std::byte>{bytes, bytes + sqlite3_column_bytes(row, column)};
    }
    default:
      return {};
  }
}

std::size_t bytes_of(const ReportCell& cell) noexcept {
  if (const auto* const text = std::get_if<std::string>(&cell)) return text->size();
  if (const auto* const blob = std::get_if<std::vector<std::byte>>(&cell)) return blob->size();
  return 0;
}

}  // namespace

ReportConnection::ReportConnection(const std::filesystem::path& directory,
                                   const ReportLimits& limits)
    : database_(opened(directory)), limits_(limits) {
  sqlite3* const connection = database_->connection().getHandle();
  add_record_tables(*database_);
  for (const Limit& limit : sqlite_limits) sqlite3_limit(connection, limit.what, limit.value);
  sqlite3_set_authorizer(connection, &authorize_report, nullptr);
}

Report ReportConnection::answer(const std::string& sql) {
  sqlite3* const connection = database_->connection().getHandle();
  const Deadline deadline{connection, limits_.time_ms};
  const StatementPtr statement = prepared(connection, sql, limits_);
  const int column_count = sqlite3_column_count(statement.get());
  Report report;
  for (int i = 0; i < column_count; ++i) {
    report.columns.emplace_back(sqlite3_column_name(statement.get(), i));
  }
  std::size_t bytes = 0;
  int code = SQLITE_ROW;
  while ((code = sqlite3_step(statement.get())) == SQLITE_ROW) {
    std::vector<ReportCell>& row = report.rows.emplace_back();
    for (int i = 0; i < column_count; ++i) {
      row.push_back(cell_of(statement.get(), i));
      bytes += bytes_of(row.back());
      if (report.rows.size() <= limits_.rows && bytes <= limits_.bytes) continue;
      fail(DatabaseErrorKind::BadInput, "it has more than " + std::to_string(limits_.rows) +
                                            " rows or " + std::to_string(limits_.bytes >> 20U) +
                                            " MB; add a LIMIT");
    }
  }
  if (code != SQLITE_DONE) fail_as_sqlite(connection, limits_);
  return report;
}

}  // namespace hallux::database
