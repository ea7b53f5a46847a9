#include "database/reports/report_connection.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "database/audit/audit.h"
#include "database/reports/report_access.h"
#include "database/reports/report_process.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

/// Processes for reports, which begin before anything is opened.
struct TwoReports {
  ReportProcess first, second;
};

class ReportTest : public testing::Test, protected TwoReports, protected SomeCourse {
 protected:
  Report answer(const std::string& sql, const ReportLimits& limits = {}) {
    return ReportConnection{database().directory(), limits}.answer(sql);
  }
  DatabaseErrorKind kind_of(const std::string& sql, const ReportLimits& limits = {}) {
    return kind_thrown([&] { answer(sql, limits); });
  }
};

TEST_F(ReportTest, AnswersWithNamedColumnsAndTypedCells) {
  const Report report =
      answer("SELECT 1 AS one, 2.5 AS half, 'a' AS text, x'01' AS blob, NULL AS n");
  EXPECT_EQ(report.columns, (std::vector<std::string>{"one", "half", "text", "blob", "n"}));
  ASSERT_EQ(report.rows.size(), 1U);
  const auto& row = report.rows.front();
  EXPECT_EQ(std::get<std::int64_t>(row[0]), 1);
  EXPECT_EQ(std::get<double>(row[1]), 2.5);
  EXPECT_EQ(std::get<std::string>(row[2]), "a");
  EXPECT_EQ(std::get<std::vector<std::byte>>(row[3]), std::vector{std::byte{1}});
  EXPECT_TRUE(std::holds_alternative<std::monostate>(row[4]));
}

TEST_F(ReportTest, CountsAttemptsOfPeopleByNumber) {
  scored_by("ada", 50'000);
  const Report report =
      answer("SELECT a.person_id, s.score_milli FROM attempt a JOIN score s USING (attempt_id)");
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_EQ(std::get<std::int64_t>(report.rows[0][0]), id_of("ada").number);
  EXPECT_EQ(std::get<std::int64_t>(report.rows[0][1]), 50'000);
}

TEST_F(ReportTest, DecidesAboutEachTableOfTheSchema) {
  SQLite::Statement tables{database().connection(),
                           "SELECT name FROM sqlite_schema WHERE type IN ('table', 'view')"};
  int count = 0;
  while (tables.executeStep()) {
    const std::string name = tables.getColumn(0).getString();
    EXPECT_TRUE(report_access(name).has_value()) << name << ": decide in report_access.cpp";
    ++count;
  }
  EXPECT_GT(count, 30);
}

TEST_F(ReportTest, KeepsSecretsNamesAndTextsClosed) {
  for (const char* sql :
       {"SELECT argon2id FROM password", "SELECT * FROM one_time_code",
        "SELECT login FROM person_detail", "SELECT count(*) FROM session",
        "SELECT failures FROM sign_in_guard", "SELECT text FROM audit_text",
        "SELECT text FROM note", "SELECT * FROM note_reply", "SELECT question FROM help_request",
        "SELECT answer FROM help_request", "SELECT reason FROM decision", "SELECT kind FROM notice",
        "SELECT (SELECT group_concat(login) FROM person_detail)",
        "WITH a AS (SELECT * FROM password) SELECT count(*) FROM a",
        "SELECT person_id FROM person ORDER BY (SELECT login FROM person_detail LIMIT 1)"}) {
    EXPECT_EQ(kind_of(sql), DatabaseErrorKind::Refused) << sql;
  }
  EXPECT_TRUE(answer("SELECT moment_us, is_private FROM note").rows.empty());
}

TEST_F(ReportTest, OnlyReads) {
  for (const char* sql :
       {"DELETE FROM attempt", "UPDATE person SET is_disabled = 1",
        "INSERT INTO setting VALUES (1,2,3)", "DROP TABLE audit", "CREATE TEMP TABLE t (a)",
        "ATTACH ':memory:' AS other", "ATTACH '/tmp/other.db' AS other",
        "PRAGMA secure_delete = OFF", "PRAGMA table_info(person)",
        "SELECT * FROM pragma_table_info('person')", "BEGIN IMMEDIATE",
        "VACUUM INTO '/tmp/copy.db'", "SELECT load_extension('/tmp/x.so')",
        "SELECT data FROM sqlite_dbpage", "EXPLAIN DELETE FROM attempt"}) {
    const DatabaseErrorKind kind = kind_of(sql);
    EXPECT_TRUE(kind == DatabaseErrorKind::Refused || kind == DatabaseErrorKind::BadInput) << sql;
  }
  EXPECT_EQ(kind_of("DELETE FROM attempt"), DatabaseErrorKind::Refused);
}

TEST_F(ReportTest, IsOneStatement) {
  EXPECT_EQ(kind_of("SELECT 1; SELECT 2"), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of(""), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of("-- nothing"), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of("SELEC 1"), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of(std::string{"SELECT 1\0 DELETE", 16}), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of("SELECT '" + std::string(200'000, 'a') + "'"), DatabaseErrorKind::BadInput);
  EXPECT_EQ(answer("SELECT 1;  \n").rows.size(), 1U);
}

TEST_F(ReportTest, TakesNoMoreThanItsTimeRowsAndBytes) {
  const std::string endless = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) ";
  const ReportLimits small{50, 1000, 100'000};
  EXPECT_EQ(kind_of(endless + "SELECT count(*) FROM n", small), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of(endless + "SELECT i FROM n", {5000, 1000, 100'000}),
            DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of("SELECT printf('%200000d', 1)", small), DatabaseErrorKind::BadInput);
  EXPECT_EQ(answer("SELECT 1", small).rows.size(), 1U);
}

TEST_F(ReportTest, ByAnAdministratorIsWrittenToTheAuditAlsoWhereItFails) {
  administrator().report("SELECT count(*) FROM attempt", first);
  EXPECT_EQ(last_audit().action, "report_run");
  EXPECT_EQ(last_audit().text, "SELECT count(*) FROM attempt");
  EXPECT_EQ(kind_thrown([&] { administrator().report("SELECT * FROM password", second); }),
            DatabaseErrorKind::Refused);
  EXPECT_EQ(last_audit().text, "SELECT * FROM password");
}

TEST(OpenHouseReport, IsAnybodysWhereThereAreNoPeople) {
  ReportProcess first, second;
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  auto house = OpenHouse::enter(database);
  ASSERT_TRUE(house.has_value());
  EXPECT_EQ(house->report("SELECT count(*) FROM attempt", first).rows.size(), 1U);
  house->add_first_administrator({"root", "", true}, secret(good_password), cheap);
  EXPECT_EQ(kind_thrown([&] { house->report("SELECT 1", second); }), DatabaseErrorKind::Refused);
}

}  // namespace

}  // namespace hallux::database
