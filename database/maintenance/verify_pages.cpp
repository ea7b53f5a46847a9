#include "database/maintenance/verify_pages.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <vector>

#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// A file up to here is checked as a whole, pages that belong to nothing included: a fraction of a
/// second (measured). Of a larger one the chunks, nearly all of it, are read piece by piece
/// instead: a page of theirs that is wrong does not fit the chain.
constexpr std::uintmax_t whole_check_bytes_max = 64 * 1024 * 1024;
constexpr std::int64_t chunks_at_once = 5000;
constexpr std::string_view chunk_table = "chunk";

void run_check(Database& database, const std::string& check) {
  const auto answer = single<std::string>(database, check);
  if (answer != "ok") fail_altered(database, "a page (" + answer + ")");
}

void check_keys(Database& database, const std::string& argument) {
  auto keys = prepared(database, "PRAGMA foreign_key_check" + argument);
  if (!keys.executeStep()) return;
  fail_altered(database, "row " + std::to_string(keys.getColumn(1).getInt64()) + " of table " +
                             keys.getColumn(0).getString() + ", which names a missing row,");
}

std::vector<std::string> tables(Database& database) {
  return all_of<std::string>(database,
                             "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
}

void check_chunk_rows(Database& database, VerifyProgress& progress) {
  progress.begin("the indices of the chunks", 0.15);
  const auto last = single<std::int64_t>(database, "SELECT coalesce(max(chunk_id), 0) FROM chunk");
  SQLite::Statement lost{
      database.connection(),
      "SELECT c.chunk_id FROM chunk c NOT INDEXED WHERE c.chunk_id > ?1 AND c.chunk_id <= ?2 AND ("
      "NOT EXISTS (SELECT 1 FROM attempt a WHERE a.attempt_id = c.attempt_id) "
      "OR NOT EXISTS (SELECT 1 FROM chunk i INDEXED BY sqlite_autoindex_chunk_1 "
      "WHERE i.attempt_id = c.attempt_id AND i.seq = c.seq AND i.stream = c.stream "
      "AND i.chunk_id = c.chunk_id) "
      "OR NOT EXISTS (SELECT 1 FROM chunk i INDEXED BY chunk_by_tick "
      "WHERE i.attempt_id = c.attempt_id AND i.stream = c.stream "
      "AND i.first_tick = c.first_tick AND i.chunk_id = c.chunk_id)) LIMIT 1"};
  for (std::int64_t first = 0; first < last; first += chunks_at_once) {
    bind_all(lost, first, first + chunks_at_once);
    if (lost.executeStep()) {
      fail_altered(database, "chunk " + lost.getColumn(0).getString() +
                                 ", which its attempt or an index does not know,");
    }
    lost.reset();
    progress.tell(first, last);
  }
}

}  // namespace

void check_pages(Database& database, VerifyProgress& progress) {
  progress.begin("the pages", 0.1);
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(database.file(), error);
  const bool is_checked_whole = !error && bytes <= whole_check_bytes_max;
  translating(database, "check the pages", [&] {
    if (is_checked_whole) {
      run_check(database, "PRAGMA integrity_check(1)");
      progress.tell(1, 3);
      check_keys(database, "");
    } else {
      const std::vector<std::string> names = tables(database);
      for (const std::string& name : names) {
        if (name == chunk_table) continue;
        run_check(database, "PRAGMA integrity_check('" + name + "')");
        check_keys(database, "('" + name + "')");
        progress.tell(0, 1);
      }
    }
    check_chunk_rows(database, progress);
  });
}

}  // namespace hallux::database
