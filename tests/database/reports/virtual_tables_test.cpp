#include "database/reports/virtual_tables.h"

#include <gtest/gtest.h>

#include "database/reports/report_connection.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

/// A busy machine may take its time here: how long a report may take is asked elsewhere.
const ReportLimits patient{60'000};

/// Twelve recorded seconds, and a report connection to them.
class RecordTables : public testing::Test {
 protected:
  RecordTables() { id_ = record(database_, some_attempt(database_), recording_); }

  Report answer(const std::string& what, const std::string& table, const std::string& rest = "") {
    return ReportConnection{database_.directory(), patient}.answer(
        "SELECT " + what + " FROM " + table + "('" + id_.text + "') " + rest);
  }
  std::vector<std::int64_t> numbers(const Report& report) {
    std::vector<std::int64_t> found;
    for (const auto& row : report.rows) found.push_back(std::get<std::int64_t>(row.front()));
    return found;
  }
  std::string failure_of(const std::string& what, const std::string& table,
                         const std::string& rest = "") {
    try {
      answer(what, table, rest);
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::Damaged);
      return error.what();
    }
    ADD_FAILURE() << "nothing was noticed";
    return "";
  }

  TemporaryDirectory temporary_;
  Database database_ = Database::open(temporary_.data());
  simulator::Recording recording_ = some_recording(12'000);
  AttemptId id_;
};

template <typename Row>
void expect_row(const std::vector<ReportCell>& cells, const Row& row) {
  const auto values = simulator::columns_of(row);
  ASSERT_GE(cells.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::get<std::int64_t>(cells[i]), values[i]) << "column " << i;
  }
}

TEST_F(RecordTables, SamplesAreRowsByTick) {
  const Report report = answer("*", "pose_samples");
  ASSERT_EQ(report.rows.size(), recording_.samples.size());
  EXPECT_EQ(report.columns.at(1), "tool_x_in_world_um");
  for (const std::size_t i : {0U, 499U, 500U, 7'777U, 11'999U}) {
    expect_row(report.rows[i], recording_.samples[i]);
  }
}

TEST_F(RecordTables, EventsAreRows) {
  const Report report = answer("*", "cut_events");
  ASSERT_EQ(report.rows.size(), recording_.events.size());
  expect_row(report.rows.back(), recording_.events.back());
}

TEST_F(RecordTables, LinesOfTheTapeTellSwitchesFromFaults) {
  const Report report = answer("tick, handle_z_in_world_um, switches, faults, command_0",
                               "tape_lines", "WHERE tick IN (0, 1600)");
  ASSERT_EQ(report.rows.size(), 2U);
  EXPECT_EQ(std::get<std::int64_t>(report.rows[0][4]), 1);
  const auto& line = recording_.tape[1600];
  EXPECT_EQ(std::get<std::int64_t>(report.rows[1][1]),
            line.device.world_from_handle.translation_um[2]);
  EXPECT_EQ(std::get<std::int64_t>(report.rows[1][2]), line.device.switches);
  EXPECT_EQ(std::get<std::int64_t>(report.rows[1][3]), 0);
}

TEST_F(RecordTables, EachBoundOnTheTickIsKept) {
  using Ticks = std::vector<std::int64_t>;
  const auto ticks = [&](const std::string& where) {
    return numbers(answer("tick", "pose_samples", "WHERE " + where));
  };
  EXPECT_EQ(ticks("tick BETWEEN 6000 AND 6002"), (Ticks{6000, 6001, 6002}));
  EXPECT_EQ(ticks("tick > 6000 AND tick < 6002"), (Ticks{6001}));
  EXPECT_EQ(ticks("tick >= 11998"), (Ticks{11998, 11999}));
  EXPECT_EQ(ticks("tick <= 1"), (Ticks{0, 1}));
  EXPECT_EQ(ticks("tick = 499.0"), (Ticks{499}));
  EXPECT_EQ(ticks("tick > 499.5 AND tick < 500.5"), (Ticks{500}));
  EXPECT_EQ(ticks("tick IN (3, 9000)"), (Ticks{3, 9000}));
  EXPECT_EQ(ticks("tick < 0 OR tick > 12000"), Ticks{});
  EXPECT_EQ(ticks("tick = NULL"), Ticks{});
  EXPECT_EQ(ticks("tick < 'a' AND tick > 11998"), (Ticks{11999}));
  EXPECT_EQ(ticks("tick > 9e300"), Ticks{});
}

TEST_F(RecordTables, RowsComeInTheOrderAskedFor) {
  const auto down = numbers(answer("tick", "pose_samples", "ORDER BY tick DESC LIMIT 2"));
  EXPECT_EQ(down, (std::vector<std::int64_t>{11999, 11998}));
  const auto up = numbers(answer("tick", "pose_samples", "ORDER BY tick LIMIT 2"));
  EXPECT_EQ(up, (std::vector<std::int64_t>{0, 1}));
}

TEST_F(RecordTables, JoinWithAttempts) {
  const Report report = ReportConnection{database_.directory(), patient}.answer(
      "SELECT a.uuid, count(*), max(force_y_in_world_millinewton) FROM attempt a JOIN "
      "pose_samples(a.uuid) GROUP BY a.uuid");
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_EQ(std::get<std::string>(report.rows[0][0]), id_.text);
  EXPECT_EQ(std::get<std::int64_t>(report.rows[0][1]), 12'000);
  EXPECT_EQ(std::get<std::int64_t>(report.rows[0][2]), 2'500);
}

TEST_F(RecordTables, WithoutAnAttemptThereIsNoPlanAndOfAForeignOneNoRows) {
  ReportConnection connection{database_.directory(), patient};
  EXPECT_EQ(kind_thrown([&] { connection.answer("SELECT * FROM pose_samples"); }),
            DatabaseErrorKind::BadInput);
  EXPECT_TRUE(connection.answer("SELECT * FROM pose_samples('none')").rows.empty());
  EXPECT_TRUE(connection.answer("SELECT * FROM pose_samples(NULL)").rows.empty());
  EXPECT_TRUE(connection.answer("SELECT * FROM pose_samples(17)").rows.empty());
}

TEST_F(RecordTables, ADamagedChunkIsNamedAndOthersAreRead) {
  tamper(database_, "UPDATE chunk SET bytes = x'0201' WHERE seq = 9 AND stream = 1");
  EXPECT_NE(failure_of("count(*)", "pose_samples").find("samples of window 9"), std::string::npos);
  EXPECT_EQ(numbers(answer("count(*)", "pose_samples", "WHERE tick < 4000")).front(), 4000);
  EXPECT_EQ(numbers(answer("count(*)", "cut_events")).front(), 48);
}

TEST_F(RecordTables, AnAlteredLinkOrAMissingChunkIsNamed) {
  tamper(database_, "DELETE FROM chunk WHERE seq = 7 AND stream = 0");
  EXPECT_NE(failure_of("count(*)", "pose_samples").find("samples of window 7"), std::string::npos);
  tamper(database_, "UPDATE chunk SET link = zeroblob(32) WHERE seq = 3 AND stream = 2");
  EXPECT_NE(failure_of("count(*)", "cut_events", "WHERE tick < 2000").find("events of window 3"),
            std::string::npos);
}

}  // namespace

}  // namespace hallux::database
