#include "database/recording/recordings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

/// A sealed attempt of twenty seconds, and what was recorded of it.
struct Recorded {
  explicit Recorded(std::int64_t ticks = 20'000) : recording(some_recording(ticks)) {
    id = record(database, some_attempt(database), recording);
  }
  simulator::Recording part(const TickRange& ticks) {
    return load_recording_part(database, id, ticks);
  }
  void expect_damaged(const TickRange& ticks, const std::string& place) {
    try {
      part(ticks);
      ADD_FAILURE() << "nothing was noticed";
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::Damaged);
      EXPECT_NE(std::string{error.what()}.find(place), std::string::npos) << error.what();
    }
  }

  TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  simulator::Recording recording;
  AttemptId id;
};

template <typename Row>
std::vector<Row> rows_within(const std::vector<Row>& rows, const TickRange& ticks) {
  std::vector<Row> inside;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(inside),
               [&](const Row& row) { return row.tick >= ticks.first && row.tick < ticks.end; });
  return inside;
}

TEST(Recordings, ALongOneIsReadBackAsItWas) {
  Recorded recorded;
  EXPECT_TRUE(is_same(load_recording(recorded.database, recorded.id), recorded.recording));
  EXPECT_EQ(check_recording(recorded.database, recorded.id), 120);
}

TEST(Recordings, APartHoldsTheRowsOfItsTicks) {
  Recorded recorded;
  for (const TickRange ticks : {TickRange{0, 1}, TickRange{9'990, 10'010}, TickRange{3'000, 4'000},
                                TickRange{19'999, 30'000}, TickRange{0, 20'000}}) {
    const simulator::Recording part = recorded.part(ticks);
    EXPECT_EQ(part.tape, rows_within(recorded.recording.tape, ticks)) << ticks.first;
    EXPECT_EQ(part.samples, rows_within(recorded.recording.samples, ticks)) << ticks.first;
    EXPECT_EQ(part.events, rows_within(recorded.recording.events, ticks)) << ticks.first;
  }
}

TEST(Recordings, APartOutsideOfItIsEmpty) {
  Recorded recorded{2'000};
  EXPECT_TRUE(recorded.part({5'000, 6'000}).tape.empty());
  EXPECT_TRUE(recorded.part({-20, 0}).tape.empty());
}

TEST(Recordings, APartNoticesADamagedChunkInIt) {
  Recorded recorded;
  tamper(recorded.database, "UPDATE chunk SET bytes = x'0201020304' WHERE seq = 20 AND stream = 1");
  recorded.expect_damaged({10'100, 10'200}, "samples of window 20");
  EXPECT_EQ(recorded.part({5'000, 5'100}).samples.size(), 100U);
}

TEST(Recordings, APartNoticesAChunkTakenOutOfItsWindow) {
  Recorded recorded;
  tamper(recorded.database, "DELETE FROM chunk WHERE seq = 20 AND stream = 1");
  recorded.expect_damaged({10'100, 10'200}, "events of window 20");
}

TEST(Recordings, APartNoticesThatTheLastChunkOfItsWindowIsGone) {
  Recorded recorded;
  tamper(recorded.database, "DELETE FROM chunk WHERE seq = 20 AND stream = 2");
  recorded.expect_damaged({10'100, 10'200}, "tape of window 21");
}

TEST(Recordings, APartAtTheEndNoticesThatTheSealDoesNotFit) {
  Recorded recorded;
  tamper(recorded.database, "DELETE FROM chunk WHERE seq = 39 AND stream = 2");
  recorded.expect_damaged({19'900, 20'000}, "does not fit its seal");
}

TEST(Recordings, TheFirstDamagedChunkIsNamedWhicheverThreadFindsOne) {
  const std::string unreadable = "UPDATE chunk SET bytes = x'0201020304' WHERE ";
  const std::string unlinked = "UPDATE chunk SET link = zeroblob(32) WHERE ";
  const std::vector<std::pair<std::string, std::string>> damages{
      {unlinked + "seq IN (12, 30)", "tape of window 12"},
      {unreadable + "(seq = 12 AND stream = 1) OR (seq = 14 AND stream = 0)",
       "samples of window 12"},
      {unreadable + "(seq = 12 AND stream = 0) OR (seq = 10 AND stream = 2)",
       "events of window 10"},
      {unreadable + "(seq = 30 AND stream = 0) OR (seq = 31 AND stream = 1)", "tape of window 30"}};
  for (const auto& [damage, first] : damages) {
    Recorded recorded;
    tamper(recorded.database, damage);
    recorded.expect_damaged({0, 20'000}, first);
  }
}

TEST(Recordings, AStreamOfAnotherNumberIsDamageAndNoStream) {
  Recorded recorded{1'000};
  tamper(recorded.database,
         "PRAGMA ignore_check_constraints = ON; UPDATE chunk SET stream = 7 WHERE seq = 1 AND "
         "stream = 2");
  EXPECT_THROW(load_recording(recorded.database, recorded.id), DatabaseError);
}

}  // namespace

}  // namespace hallux::database
