/// Rows that are written past the audit: none by this program, and each by another tool is named.
#include "database/store/changed_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "database/audit/audit.h"
#include "database/maintenance/verify.h"
#include "database/store/sql.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

std::vector<std::string> tables_of(Database& database) {
  return all_of<std::string>(database, "SELECT name FROM sqlite_schema WHERE type = 'table'");
}

std::vector<std::string> columns_of(Database& database, std::string_view table) {
  return all_of<std::string>(database, "SELECT name FROM pragma_table_info(?)", table);
}

TEST(ChangedRows, EveryTableOfTheSchemaIsAccountedForOrExemptWithItsReason) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  std::set<std::string> decided;
  for (const AccountedTable& table : accounted_tables) decided.emplace(table.name);
  for (const ExemptTable& table : exempt_tables) {
    EXPECT_FALSE(table.reason.empty());
    EXPECT_TRUE(decided.emplace(table.name).second) << table.name << " is both";
  }
  for (const std::string& table : tables_of(database)) {
    EXPECT_EQ(decided.erase(table), 1U) << table << ": decide in changed_rows.h";
  }
  EXPECT_TRUE(decided.empty()) << *decided.begin() << " is no table";
}

TEST(ChangedRows, AKeyIsOfTheFirstColumns) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  for (const AccountedTable& table : accounted_tables) {
    const auto columns = columns_of(database, table.name);
    std::string keys = columns.at(0);
    for (int i = 1; i < table.key_count; ++i)
      keys += ", " + columns.at(static_cast<std::size_t>(i));
    EXPECT_EQ(keys, table.keys) << table.name;
    const bool has_left_out =
        table.left_out.empty() || std::ranges::count(columns, table.left_out) == 1;
    EXPECT_TRUE(has_left_out) << table.name;
  }
}

TEST(ChangedRows, NothingIsCommittedPastTheAudit) {
  SomeCourse course;
  Database& database = course.database();
  const char* const count = "SELECT count(*) FROM person WHERE is_administrator = 1";
  const int before = single<int>(database, count);
  EXPECT_THROW(database.connection().exec("UPDATE person SET is_administrator = 1"),
               SQLite::Exception);
  EXPECT_EQ(single<int>(database, count), before);
}

TEST(ChangedRows, WhatNoActExplainsIsAnActOfTheProgram) {
  SomeCourse course;
  Database& database = course.database();
  in_transaction(database, "try",
                 [&] { execute(database, "UPDATE cohort SET name = name || '!'"); });
  EXPECT_EQ(read_audit(database).back().entry.action, "rows_changed");
  EXPECT_TRUE(verify(database).is_whole());
}

TEST(ChangedRows, WhatIsUndoneIsForgotten) {
  SomeCourse course;
  Database& database = course.database();
  const std::size_t before = read_audit(database).size();
  EXPECT_THROW(in_transaction(database, "try",
                              [&] {
                                execute(database, "UPDATE cohort SET name = name || '!'");
                                throw DatabaseError{DatabaseErrorKind::BadInput, "no"};
                              }),
               DatabaseError);
  in_transaction(database, "try", [] {});
  EXPECT_EQ(read_audit(database).size(), before);
  EXPECT_TRUE(verify(database).is_whole());
}

}  // namespace

}  // namespace hallux::database
