#include "database/backup.h"

#include <SQLiteCpp/Backup.h>
#include <sqlite3.h>

#include <system_error>

#include "database/files.h"
#include "database/sql.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// 4 MiB between two questions whether to go on.
constexpr int pages_between_reports = 1024;

/// Gone where the backup ends before it is complete.
class PartialFile {
 public:
  explicit PartialFile(fs::path file) : file_(std::move(file)) {}
  ~PartialFile() {
    std::error_code ignored;
    fs::remove(file_, ignored);
    fs::remove(file_.string() + "-journal", ignored);
  }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  const fs::path& file() const noexcept { return file_; }

 private:
  fs::path file_;
};

std::int64_t size_of(Database& database) {
  return translating(database, "ask for the size", [&] {
    SQLite::Statement row{database.connection(),
                          "SELECT page_count * page_size FROM pragma_page_count, pragma_page_size"};
    row.executeStep();
    return row.getColumn(0).getInt64();
  });
}

void check_room(const Database& database, const fs::path& directory, std::int64_t bytes) {
  std::error_code error;
  const fs::space_info space = fs::space(directory, error);
  if (error || space.available >= 2 * static_cast<std::uintmax_t>(bytes)) return;
  throw DatabaseError{DatabaseErrorKind::Full, "no backup of " + database.file().string() +
                                                   " was made: " + directory.string() +
                                                   " has less than twice its size free; free some "
                                                   "space or name another directory"};
}

/// "hallux-20260301-142500.db", and with a number where that is taken.
fs::path free_name(Database& database, const fs::path& directory) {
  const std::string utc = utc_now(database);
  const std::string stem = "hallux-" + utc.substr(0, 4) + utc.substr(5, 2) + utc.substr(8, 2) +
                           "-" + utc.substr(11, 2) + utc.substr(14, 2) + utc.substr(17, 2);
  fs::path file = directory / (stem + ".db");
  for (int number = 2; fs::exists(file); ++number) {
    file = directory / (stem + "-" + std::to_string(number) + ".db");
  }
  return file;
}

/// needs   `source` reads from one snapshot: without it, each commit of a writer would begin the copy anew
void copy_pages(SQLite::Database& source, SQLite::Database& target,
                const std::function<bool(double)>& progress) {
  SQLite::Backup backup{target, source};
  while (backup.executeStep(pages_between_reports) != SQLITE_DONE) {
    const double total = static_cast<double>(backup.getTotalPageCount());
    const double left = static_cast<double>(backup.getRemainingPageCount());
    if (progress && total > 0.0 && !progress(0.9 * (1.0 - left / total))) {
      throw BackupStopped{"the backup was stopped; no file was left"};
    }
  }
}

/// One file without a log beside it, and whole.
void finish_file(SQLite::Database& copy) {
  copy.exec("PRAGMA journal_mode = DELETE");
  SQLite::Statement check{copy, "PRAGMA quick_check(1)"};
  check.executeStep();
  const std::string answer = check.getColumn(0).getString();
  if (answer == "ok") return;
  throw DatabaseError{DatabaseErrorKind::Damaged,
                      copy.getFilename() + " was not copied well (" + answer +
                          "); check the disk, and the database with `hallux verify`"};
}

}  // namespace

Backup back_up(Database& database, const fs::path& directory,
               const std::function<bool(double)>& progress) {
  Database source = database.open_again();
  make_private_directory(directory);
  const std::int64_t bytes = size_of(source);
  check_room(source, directory, bytes);
  const fs::path file = free_name(source, directory);
  const PartialFile partial{file.string() + ".part"};
  make_private_file(partial.file());
  translating(source, "back up", [&] {
    SQLite::Transaction snapshot{source.connection()};
    SQLite::Statement begin{source.connection(), "SELECT count(*) FROM sqlite_schema"};
    begin.executeStep();
    SQLite::Database target{partial.file().string(), SQLite::OPEN_READWRITE};
    copy_pages(source.connection(), target, progress);
    finish_file(target);
  });
  std::error_code error;
  fs::rename(partial.file(), file, error);
  if (error) throw file_error(file, "name the backup", error.value());
  if (progress) progress(1.0);
  return {file, bytes};
}

void copy_whole(Database& source, Database& target) {
  translating(target, "copy a database", [&] {
    SQLite::Backup backup{target.connection(), source.connection()};
    if (backup.executeStep(-1) == SQLITE_DONE) return;
    throw DatabaseError{DatabaseErrorKind::Locked,
                        "could not write " + target.file().string() +
                            ": another program keeps it busy; close that program and try again"};
  });
}

}  // namespace hallux::database
