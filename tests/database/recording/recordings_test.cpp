#include "database/recording/recordings.h"

#include <gtest/gtest.h>

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
  void expect_damaged(const std::string& place) {
    try {
      load_recording(database, id);
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

TEST(Recordings, ALongOneIsReadBackAsItWas) {
  Recorded recorded;
  EXPECT_TRUE(is_same(load_recording(recorded.database, recorded.id), recorded.recording));
  EXPECT_EQ(check_recording(recorded.database, recorded.id), 120);
}

TEST(Recordings, OfItsOutputsAloneTheTapeIsCheckedAndNotKept) {
  Recorded recorded;
  const simulator::Recording outputs =
      load_recording(recorded.database, recorded.id, RecordingPart::Outputs);
  EXPECT_EQ(outputs.samples, recorded.recording.samples);
  EXPECT_EQ(outputs.events, recorded.recording.events);
  EXPECT_EQ(outputs.engine, recorded.recording.engine);
  EXPECT_TRUE(outputs.tape.empty());
  EXPECT_EQ(outputs.tape.capacity(), 0U);
  tamper(recorded.database, "UPDATE chunk SET link = zeroblob(32) WHERE seq = 12 AND stream = 0");
  EXPECT_THROW(load_recording(recorded.database, recorded.id, RecordingPart::Outputs),
               DatabaseError);
}

std::vector<simulator::TapeLine> visited(const PackedTape& tape) {
  std::vector<simulator::TapeLine> seen;
  tape.lines().visit([&](const simulator::TapeLine& line) { seen.push_back(line); });
  return seen;
}

TEST(Recordings, APackedTapeHasTheSameLinesEachTimeTheyAreVisited) {
  Recorded recorded;
  const PackedRecording packed = load_packed_recording(recorded.database, recorded.id);
  EXPECT_EQ(packed.outputs.samples, recorded.recording.samples);
  EXPECT_EQ(packed.outputs.events, recorded.recording.events);
  EXPECT_EQ(packed.outputs.engine, recorded.recording.engine);
  EXPECT_TRUE(packed.outputs.tape.empty());
  EXPECT_EQ(packed.tape.lines().count(), recorded.recording.tape.size());
  EXPECT_EQ(visited(packed.tape), recorded.recording.tape);
  const PackedTape copy = packed.tape;
  EXPECT_EQ(visited(copy), recorded.recording.tape);
}

TEST(Recordings, APackedTapeIsCheckedAsItIsRead) {
  for (const char* damage :
       {"UPDATE chunk SET bytes = x'0201020304' WHERE seq = 12 AND stream = 0",
        "UPDATE chunk SET link = zeroblob(32) WHERE seq = 12 AND stream = 0"}) {
    Recorded recorded;
    tamper(recorded.database, damage);
    EXPECT_THROW(load_packed_recording(recorded.database, recorded.id), DatabaseError) << damage;
  }
}

TEST(Recordings, AChunkTakenOutOfItsWindowIsNoticed) {
  Recorded recorded;
  tamper(recorded.database, "DELETE FROM chunk WHERE seq = 20 AND stream = 1");
  recorded.expect_damaged("events of window 20");
}

TEST(Recordings, TheLastChunkOfAWindowIsMissed) {
  Recorded recorded;
  tamper(recorded.database, "DELETE FROM chunk WHERE seq = 20 AND stream = 2");
  recorded.expect_damaged("tape of window 21");
}

TEST(Recordings, WithoutItsLastChunkItDoesNotFitItsSeal) {
  Recorded recorded;
  tamper(recorded.database, "DELETE FROM chunk WHERE seq = 39 AND stream = 2");
  recorded.expect_damaged("does not fit its seal");
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
    recorded.expect_damaged(first);
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
