/// SQLite's own copy takes all pages, and nearly all pages are chunks that lie in the backup
/// already. So rows are copied, table after table, within one reading: who records meanwhile is not
/// kept waiting, and a copy that is stopped leaves a file without a name. Tables come before what
/// is made upon them, so that no trigger runs.
#include "database/maintenance/table_copy.h"

#include <sqlite3.h>

#include <string>
#include <vector>

#include "database/store/files.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// How often it is asked whether to go on.
constexpr int rows_between_questions = 256;

struct Made {
  std::string name, sql;
};

/// The tables, or with them in place what is made upon them.
std::vector<Made> made_in(SQLite::Database& source, bool tables) {
  SQLite::Statement rows{source,
                         "SELECT name, sql FROM sqlite_schema WHERE (type = 'table') = ? AND sql "
                         "IS NOT NULL AND name NOT LIKE 'sqlite_%' ORDER BY rowid"};
  rows.bind(1, tables ? 1 : 0);
  return rows_of(std::move(rows), &Made::name, &Made::sql);
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string{"\"\""} : std::string{c};
  return text + "\"";
}

/// Rows from one connection to another, byte for byte.
class RowCopier {
 public:
  RowCopier(SQLite::Database& source, SQLite::Database& target,
            const std::function<bool()>& goes_on)
      : source_(source), target_(target), goes_on_(goes_on) {}

  /// False where it was not to go on.
  bool copy(const std::string& table, const std::string& condition) {
    SQLite::Statement rows{source_, "SELECT * FROM main." + quoted(table) + condition};
    std::string places = "?";
    for (int i = 1; i < rows.getColumnCount(); ++i) places += ", ?";
    SQLite::Statement insert{target_, "INSERT INTO " + quoted(table) + " VALUES (" + places + ")"};
    for (int count = 0; rows.executeStep(); ++count) {
      if (count % rows_between_questions == 0 && !goes_on_()) return false;
      for (int i = 0; i < rows.getColumnCount(); ++i) bind(insert, i + 1, rows.getColumn(i));
      insert.exec();
      insert.reset();
    }
    return goes_on_();
  }

 private:
  static void bind(SQLite::Statement& insert, int at, const SQLite::Column& value) {
    switch (value.getType()) {
      case SQLITE_INTEGER:
        insert.bind(at, value.getInt64());
        return;
      case SQLITE_FLOAT:
        insert.bind(at, value.getDouble());
        return;
      case SQLITE_TEXT:
        insert.bind(at, value.getString());
        return;
      case SQLITE_BLOB:
        insert.bind(at, value.getBlob(), value.getBytes());
        return;
      default:
        insert.bind(at);
    }
  }

  SQLite::Database& source_;
  SQLite::Database& target_;
  const std::function<bool()>& goes_on_;
};

void leave_out(SQLite::Database& source, const std::vector<AttemptId>& elsewhere) {
  source.exec("DROP TABLE IF EXISTS temp.elsewhere");
  source.exec("CREATE TEMP TABLE elsewhere (attempt_id INTEGER PRIMARY KEY) STRICT");
  SQLite::Statement insert{source,
                           "INSERT OR IGNORE INTO temp.elsewhere SELECT attempt_id FROM "
                           "main.attempt WHERE uuid = ?"};
  for (const AttemptId& attempt : elsewhere) {
    insert.bind(1, attempt.text);
    insert.exec();
    insert.reset();
  }
}

bool copy_rows(SQLite::Database& source, SQLite::Database& target,
               const std::function<bool()>& goes_on) {
  RowCopier copier{source, target, goes_on};
  const std::vector<Made> tables = made_in(source, true);
  for (const Made& table : tables) target.exec(table.sql);
  for (const Made& table : tables) {
    const bool is_recorded = table.name == "chunk" || table.name == "display_fact";
    if (!copier.copy(table.name,
                     is_recorded
                         ? " WHERE attempt_id NOT IN (SELECT attempt_id FROM temp.elsewhere)"
                         : "")) {
      return false;
    }
  }
  target.exec("DELETE FROM sqlite_sequence");
  if (!copier.copy("sqlite_sequence", "")) return false;
  for (const Made& made : made_in(source, false)) target.exec(made.sql);
  return true;
}

std::string number_of(SQLite::Database& source, const char* pragma) {
  SQLite::Statement row{source, pragma};
  row.executeStep();
  return row.getColumn(0).getString();
}

void check_copy(SQLite::Database& copy) {
  SQLite::Statement check{copy, "PRAGMA quick_check(1)"};
  check.executeStep();
  const std::string answer = check.getColumn(0).getString();
  if (answer == "ok") return;
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      copy.getFilename() + " was not copied well (" + answer +
                          "); check the disk, and the database with `hallux verify`"};
}

}  // namespace

void copy_tables(Database& source, const std::filesystem::path& file,
                 const std::function<std::vector<AttemptId>()>& elsewhere,
                 const std::function<bool()>& goes_on) {
  make_private_file(file);
  translating(source, "back up the tables", [&] {
    SQLite::Database& from = source.connection();
    SQLite::Database target{file.string(), SQLite::OPEN_READWRITE, 0, source.vfs_name()};
    // Made anew where it is lost: what is written is synced once, at the end.
    target.exec("PRAGMA page_size = " + number_of(from, "PRAGMA page_size"));
    target.exec("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF;");
    SQLite::Transaction snapshot{from};
    target.exec("BEGIN");
    number_of(from, "SELECT count(*) FROM main.sqlite_schema");
    leave_out(from, elsewhere());
    if (!copy_rows(from, target, goes_on)) return;
    target.exec("COMMIT");
    target.exec("PRAGMA application_id = " + number_of(from, "PRAGMA application_id"));
    target.exec("PRAGMA user_version = " + number_of(from, "PRAGMA user_version"));
    check_copy(target);
  });
}

std::string schema_text(Database& database) {
  return translating(database, "read the schema", [&] {
    auto rows = prepared(database,
                         "SELECT type || ' ' || name || ': ' || coalesce(sql, '') FROM "
                         "sqlite_schema ORDER BY type, name");
    std::string text;
    while (rows.executeStep()) text += rows.getColumn(0).getString() + "\n";
    return text;
  });
}

}  // namespace hallux::database
