/// Every column of every table, altered by another tool in four ways: named by verify, or on the
/// list of docs/security.md with the reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <set>
#include <thread>

#include "database/course/measurements.h"
#include "database/maintenance/verify.h"
#include "database/recording/display_facts.h"
#include "database/store/changed_rows.h"
#include "database/store/sql.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// Rows that are kept now have another time than those before.
void wait_a_moment() { std::this_thread::sleep_for(std::chrono::milliseconds{2}); }

/// A course in which every table has rows; at least two where two can be.
class FullCourse : public SomeCourse {
 public:
  FullCourse() {
    const AttemptId first = scored_by("ada", 50'000);
    wait_a_moment();
    const AttemptId second = scored_by("eve", 60'000);
    InstructorDesk kim = instructor("kim", autumn());
    const NoteId note = kim.add_note({first, {}, false, "look"});
    trainee("ada").reply(note, "where?");
    const HelpRequestId asked = trainee("ada").ask_for_help({first, {}, "why?"});
    wait_a_moment();
    kim.add_note({first, {}, false, "again"});
    trainee("ada").reply(note, "there?");
    trainee("ada").ask_for_help({first, {}, "how?"});
    kim.answer(asked, "so");
    kim.decide({first, DecisionKind::Overridden, 70'000, "the station slipped"});
    administrator().add_person_with_code({"new", "", false}, cheap);
    wait_a_moment();
    instructor("lee", spring()).decide({second, DecisionKind::Confirmed, 0, "seen"});
    administrator().add_person_with_code({"newer", "", false}, cheap);
    administrator().correct_name("eve", "Eve of Spring");
    for (const AttemptId& id : {first, second})
      store_measurements(database(), id, {Digest{{1}}, 1}, some_measurements(), std::nullopt);
    store_display_facts(database(), number_of(second), some_display_facts(300));
  }

 private:
  std::int64_t number_of(const AttemptId& id) { return load_header(database(), id).order; }
};

/// Rows of a table without a rowid are told apart by another number: here one attempt's by ticks.
std::string by_row_of(const std::string& table, std::string sql) {
  if (table != "display_fact") return sql;
  for (std::size_t at = 0; (at = sql.find("rowid", at)) != std::string::npos;)
    sql.replace(at, 5, "tick");
  return sql;
}

std::string in_table(const std::string& table, const std::string& column) {
  return table + "." + column;
}

std::string last_row_removed(const std::string& table) {
  return "DELETE FROM " + table + " WHERE rowid = (SELECT max(rowid) FROM " + table + ")";
}

/// In its first and its last row.
bool has_two_values(Database& database, const std::string& table, const std::string& column) {
  const std::string rows = "SELECT " + column + " FROM " + table + " ORDER BY rowid ";
  return single<bool>(
      database, by_row_of(table, "SELECT (" + rows + "LIMIT 1) IS NOT (" + rows + "DESC LIMIT 1)"));
}

/// What another tool can do to a column, as SQL.
std::string changed(const std::string& table, const std::string& column) {
  return "UPDATE " + table + " SET " + column + " = CASE typeof(" + column +
         ") WHEN 'integer' THEN " + column + " + 1 WHEN 'real' THEN " + column +
         " + 1 WHEN 'text' THEN " + column + " || 'x' WHEN 'blob' THEN CAST(zeroblob(length(" +
         column + ")) AS BLOB) ELSE 1 END WHERE rowid = (SELECT max(rowid) FROM " + table + ")";
}

std::string exchanged(const std::string& table, const std::string& column) {
  return "CREATE TEMP TABLE two AS SELECT rowid AS r, " + column + " AS v FROM " + table +
         " WHERE rowid IN ((SELECT min(rowid) FROM " + table + "), (SELECT max(rowid) FROM " +
         table + ")); UPDATE " + table + " SET " + column +
         " = 'between' WHERE rowid = (SELECT max(r) FROM two); UPDATE " + table + " SET " + column +
         " = (SELECT v FROM two ORDER BY r DESC LIMIT 1) WHERE rowid = (SELECT min(r) FROM two); "
         "UPDATE " +
         table + " SET " + column +
         " = (SELECT v FROM two ORDER BY r LIMIT 1) WHERE rowid = (SELECT max(r) FROM two)";
}

/// Without what the schema defends itself by, which is there again afterwards.
std::string undefended(Database& database, const std::string& sql) {
  std::string drops, makes;
  SQLite::Statement triggers{database.connection(),
                             "SELECT name, sql FROM sqlite_schema WHERE type = 'trigger'"};
  while (triggers.executeStep()) {
    drops += "DROP TRIGGER " + triggers.getColumn(0).getString() + "; ";
    makes += triggers.getColumn(1).getString() + "; ";
  }
  return "PRAGMA ignore_check_constraints = ON; " + drops + sql + "; " + makes;
}

class Tampering : public testing::Test {
 protected:
  static void SetUpTestSuite() { course = std::make_unique<FullCourse>(); }
  static void TearDownTestSuite() { course.reset(); }

  /// Whether verify names what `sql` does to a copy of the course; nothing where SQLite refuses it,
  /// or nothing changes by it.
  std::optional<bool> is_named(const std::string& sql) {
    const TemporaryDirectory copy;
    fs::create_directory(copy.data());
    Database& whole = course->database();
    single<int>(whole, "PRAGMA wal_checkpoint(TRUNCATE)");
    fs::copy_file(whole.file(), copy.data() / "hallux.db");
    {
      SQLite::Database tool{(copy.data() / "hallux.db").string(), SQLite::OPEN_READWRITE};
      const int before = tool.getTotalChanges();
      try {
        tool.exec(undefended(whole, sql));
      } catch (const SQLite::Exception&) {
        return std::nullopt;
      }
      if (tool.getTotalChanges() == before) return std::nullopt;
    }
    OpenOptions reading;
    reading.access = Access::ReadOnly;
    Database altered = Database::open(copy.data(), reading);
    return !verify(altered).is_whole();
  }

  static std::unique_ptr<FullCourse> course;
};

std::unique_ptr<FullCourse> Tampering::course;

bool is_exempt(const std::string& table) {
  return std::ranges::find(exempt_tables, table, &ExemptTable::name) != exempt_tables.end();
}

TEST_F(Tampering, WithAnyColumnIsNamedOrOnTheList) {
  Database& whole = course->database();
  std::set<std::string> unnamed;
  int named = 0;
  const auto note = [&](const std::string& what, const std::string& sql) {
    const std::optional<bool> found = is_named(sql);
    if (!found) return;
    *found ? static_cast<void>(++named) : static_cast<void>(unnamed.insert(what));
  };
  for (const std::string& table : all_of<std::string>(
           whole,
           "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE "
           "'sqlite_%' AND name NOT LIKE 'audit_row' AND name NOT LIKE 'row_salt'")) {
    note(table + ": a row removed", by_row_of(table, last_row_removed(table)));
    for (const std::string& column :
         all_of<std::string>(whole, "SELECT name FROM pragma_table_info(?)", table)) {
      const std::string name = in_table(table, column);
      note(name + ": changed", by_row_of(table, changed(table, column)));
      if (has_two_values(whole, table, column)) {
        note(name + ": exchanged", by_row_of(table, exchanged(table, column)));
      }
    }
  }
  std::cout << named << " alterations named, " << unnamed.size() << " not:\n";
  for (const std::string& what : unnamed) std::cout << "  " << what << "\n";
  EXPECT_GT(named, 190);
  for (const std::string& what : unnamed) {
    EXPECT_TRUE(is_exempt(what.substr(0, what.find_first_of(".:")))) << what;
  }
}

TEST_F(Tampering, WithARowAddedIsNamed) {
  for (const char* sql :
       {"INSERT INTO person (is_administrator, created_utc) VALUES (1, '2020-01-01T00:00:00.000Z')",
        "INSERT INTO person_detail VALUES (1, 'nobody', 'Nobody')",
        "INSERT INTO membership SELECT cohort_id, 1, 'instructor', NULL FROM cohort LIMIT 1",
        "INSERT INTO setting VALUES ('x', 'y', 'z')",
        "INSERT INTO scenario_state (scenario_version_id, state, person_id, since_utc) SELECT "
        "scenario_version_id, 'published', 1, '2026-01-01' FROM scenario_version LIMIT 1",
        "INSERT INTO note (attempt_id, author_person_id, moment_us, is_private, text, written_utc) "
        "SELECT attempt_id, author_person_id, 1, 0, 'mine', written_utc FROM note LIMIT 1",
        "INSERT INTO simulated_course VALUES (1, '2026-01-01')"}) {
    const std::optional<bool> found = is_named(sql);
    EXPECT_TRUE(found.value_or(true)) << sql;
  }
}

TEST_F(Tampering, WithMeasurementsOfNoSetIsNamed) {
  const std::optional<bool> found = is_named(
      "PRAGMA foreign_keys = OFF; INSERT INTO measurement SELECT 77, line, metric, cut, hinge, "
      "zone, value, absence, done_fraction, bound, direction, detail_json, remark, start_us, "
      "end_us, x_in_bone_mm, y_in_bone_mm, z_in_bone_mm, fragment, implant FROM measurement LIMIT "
      "1");
  ASSERT_TRUE(found.has_value()) << "the row was added";
  EXPECT_TRUE(*found);
}

TEST_F(Tampering, WithTheSchemaOrItsVersionIsNamed) {
  for (const char* sql : {"DROP TRIGGER audit_is_never_altered", "DROP INDEX note_of_attempt",
                          "CREATE TABLE mine (a)", "CREATE VIEW theirs AS SELECT 1",
                          "CREATE TRIGGER own AFTER INSERT ON note BEGIN SELECT 1; END"}) {
    const TemporaryDirectory copy;
    fs::create_directory(copy.data());
    single<int>(course->database(), "PRAGMA wal_checkpoint(TRUNCATE)");
    fs::copy_file(course->database().file(), copy.data() / "hallux.db");
    { SQLite::Database{(copy.data() / "hallux.db").string(), SQLite::OPEN_READWRITE}.exec(sql); }
    OpenOptions reading;
    reading.access = Access::ReadOnly;
    Database altered = Database::open(copy.data(), reading);
    EXPECT_FALSE(verify(altered).is_whole()) << sql;
  }
}

}  // namespace

}  // namespace hallux::database
