#include "database/reports/report_process.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "simulator/base/progress.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

/// The process first: nothing is open when it begins.
class ReportProcessTest : public testing::Test {
 protected:
  Report answer(const std::string& sql) { return process_.answer(course_.directory(), sql); }
  DatabaseErrorKind kind_of(const std::string& sql) {
    return kind_thrown([&] { answer(sql); });
  }
  double seconds_of(const std::string& sql) {
    const auto before = std::chrono::steady_clock::now();
    EXPECT_EQ(kind_of(sql), DatabaseErrorKind::BadInput);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  }

  struct Course : SomeCourse {
    const std::filesystem::path& directory() { return database().directory(); }
  };
  ReportProcess process_;
  Course course_;
};

TEST_F(ReportProcessTest, BringsEveryKindOfCell) {
  const Report report =
      answer("SELECT -1 AS one, 2.5, 'a', x'00ff', NULL UNION ALL SELECT 1,2,3,4,5");
  EXPECT_EQ(report.columns.front(), "one");
  ASSERT_EQ(report.rows.size(), 2U);
  const std::vector<ReportCell> first{
      std::int64_t{-1}, 2.5, std::string{"a"}, std::vector{std::byte{0}, std::byte{255}}, {}};
  EXPECT_EQ(report.rows.front(), first);
}

TEST_F(ReportProcessTest, BringsRefusalsWithTheirKind) {
  EXPECT_EQ(kind_of("SELECT argon2id FROM password"), DatabaseErrorKind::Refused);
}

TEST_F(ReportProcessTest, BringsWrongSqlAsBadInput) {
  EXPECT_EQ(kind_of("SELEC 1"), DatabaseErrorKind::BadInput);
}

/// Minutes of one operation, between whose steps nobody is asked.
TEST_F(ReportProcessTest, EndsInTheMiddleOfAnOperation) {
  EXPECT_LT(seconds_of("WITH long(a) AS (SELECT printf('%30000000d', 0)) SELECT instr(a, "
                       "printf('%15000000d', 0) || 'x') FROM long"),
            20.0);
}

TEST_F(ReportProcessTest, TakesNoMoreMemoryThanItMay) {
  std::string sql = "SELECT printf('%30000000d', 0)";
  for (int i = 1; i < 60; ++i) sql += ", printf('%30000000d', " + std::to_string(i) + ")";
  EXPECT_LT(seconds_of(sql), 20.0);
}

TEST_F(ReportProcessTest, ClosesEveryFunctionThatIsNotListed) {
  for (const char* sql :
       {"SELECT fts3_tokenizer('simple')", "SELECT zeroblob(1)", "SELECT randomblob(1)",
        "SELECT sqlite_source_id()", "SELECT load_extension('x')"}) {
    ReportConnection connection{course_.directory()};
    EXPECT_EQ(kind_thrown([&] { connection.answer(sql); }), DatabaseErrorKind::Refused) << sql;
  }
}

TEST_F(ReportProcessTest, IsStoppedByASignal) {
  struct sigaction action {
  }, before{};
  action.sa_handler = [](int) {};
  sigaction(SIGUSR1, &action, &before);
  const pthread_t asking = pthread_self();
  std::jthread sender{[asking] {
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    pthread_kill(asking, SIGUSR1);
  }};
  EXPECT_THROW(answer("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
                      "SELECT count(*) FROM n"),
               Cancelled);
  sender.join();
  sigaction(SIGUSR1, &before, nullptr);
}

}  // namespace

}  // namespace hallux::database
