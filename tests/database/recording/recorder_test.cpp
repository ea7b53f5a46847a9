#include "database/recording/recorder.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <thread>

#include "database/audit/audit.h"
#include "database/course/begin_attempt.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

TEST(Recorder, KeepsEveryRowOfAProducerInAnotherThread) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const simulator::Recording recording = some_recording(6300);
  simulator::AttemptChannels channels{256};
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  const std::jthread producer{[&] { produce(recording, channels); }};
  const RecorderStatistics statistics = recorder.finish("{\"gaps\": 0}");
  EXPECT_TRUE(is_same(load_recording(database, recorder.attempt()), recording));
  const AttemptHeader header = load_header(database, recorder.attempt());
  EXPECT_EQ(header.state, AttemptState::Closed);
  EXPECT_EQ(header.duration_ticks, 6300);
  EXPECT_EQ(header.quality_json, "{\"gaps\": 0}");
  EXPECT_EQ(statistics.commits, 13);
  EXPECT_EQ(statistics.samples, 6300);
  EXPECT_EQ(statistics.rows, 2 * 6300 + static_cast<std::int64_t>(recording.events.size()));
  EXPECT_GT(statistics.bytes, 0);
  EXPECT_EQ(statistics.gaps + statistics.duplicates, 0);
}

TEST(Recorder, CutsWindowsByTicksWhateverTheScheduling) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const simulator::Recording recording = some_recording(2250);
  std::vector<std::string> places;
  for (const std::size_t capacity : {64U, 65536U}) {
    simulator::AttemptChannels channels{capacity};
    Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
    produce(recording, channels);
    recorder.finish("{}");
    SQLite::Statement rows{
        database.connection(),
        "SELECT group_concat(seq || ' ' || stream || ' ' || first_tick || ' ' || row_count || ' ' "
        "|| hex(bytes)) FROM chunk JOIN attempt USING (attempt_id) WHERE uuid = ?"};
    rows.bind(1, recorder.attempt().text);
    rows.executeStep();
    places.push_back(rows.getColumn(0).getString());
  }
  EXPECT_FALSE(places[0].empty());
  EXPECT_EQ(places[0], places[1]);
}

TEST(Recorder, KeepsALineAcrossAWindowsBorderWithItsSample) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  simulator::Recording recording = some_recording(1200);
  // Two ticks were missed: one line covers 498 to 500, and its sample is the tool's at 500.
  recording.tape[498].ticks = 3;
  recording.tape.erase(recording.tape.begin() + 499, recording.tape.begin() + 501);
  recording.samples.erase(recording.samples.begin() + 498, recording.samples.begin() + 500);
  const AttemptId id = record(database, some_attempt(database), recording);
  SQLite::Statement rows{database.connection(),
                         "SELECT max(row_count) FILTER (WHERE stream = 0), max(row_count) FILTER "
                         "(WHERE stream = 1) FROM chunk JOIN attempt USING (attempt_id) "
                         "WHERE uuid = ? GROUP BY seq ORDER BY seq"};
  rows.bind(1, id.text);
  for (const int expected : {498, 500, 200}) {
    ASSERT_TRUE(rows.executeStep());
    EXPECT_EQ(rows.getColumn(0).getInt(), expected);
    EXPECT_EQ(rows.getColumn(1).getInt(), expected);
  }
  EXPECT_TRUE(is_same(load_recording(database, id), recording));
}

TEST(Recorder, CommitsAWindowWhileTheNextIsFilled) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const simulator::Recording recording = some_recording(502);
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  for (std::size_t i = 0; i < recording.tape.size(); ++i) {
    channels.tape.push(recording.tape[i]);
    channels.samples.push(recording.samples[i]);
  }
  // No clock decides here: the loop ends as soon as the recorder has had two passes.
  std::size_t committed = 0;
  for (int i = 0; i < 1000 && committed == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
    committed = load_recording(database, recorder.attempt()).samples.size();
  }
  EXPECT_EQ(committed, 500U);
}

TEST(Recorder, ThatIsDroppedLeavesAnInterruptedAttemptWithAllItDrained) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const simulator::Recording recording = some_recording(700);
  AttemptId id;
  {
    simulator::AttemptChannels channels;
    Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
    id = recorder.attempt();
    produce(recording, channels);
  }
  Database later = Database::open(temporary.data());
  EXPECT_EQ(load_header(later, id).state, AttemptState::Interrupted);
  EXPECT_TRUE(is_same(load_recording(later, id), recording));
}

TEST(Recorder, ThatAbandonsLeavesAnInterruptedAttemptWithAnAct) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const simulator::Recording recording = some_recording(700);
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  produce(recording, channels);
  EXPECT_EQ(recorder.abandon().samples, 700);
  const AttemptHeader header = load_header(database, recorder.attempt());
  EXPECT_EQ(header.state, AttemptState::Interrupted);
  EXPECT_FALSE(header.seal);
  EXPECT_TRUE(is_same(load_recording(database, recorder.attempt()), recording));
  const AuditEntry act = read_audit(database).back().entry;
  EXPECT_EQ(act.action, "attempt_abandoned");
  EXPECT_EQ(act.subject_id, recorder.attempt().text);
  EXPECT_TRUE(verify(database).is_whole());
  EXPECT_THROW(recorder.abandon(), DatabaseError) << "once";
}

TEST(Recorder, SealsAnAttemptInWhichNothingHappened) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId id = record(database, some_attempt(database), {});
  EXPECT_EQ(load_header(database, id).duration_ticks, 0);
  EXPECT_TRUE(load_recording(database, id).tape.empty());
}

TEST(Recorder, BridgesTicksThatWereNeverPushed) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  simulator::Recording recording = some_recording(600);
  for (std::size_t i = 300; i < 600; ++i) {
    recording.tape[i].tick += 5'000'000'000;
    recording.samples[i].tick += 5'000'000'000;
  }
  recording.events.clear();
  const AttemptId id = record(database, some_attempt(database), recording);
  EXPECT_TRUE(is_same(load_recording(database, id), recording));
}

TEST(Recorder, CountsTicksThatTheTapeLeavesOutOrHasTwice) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  simulator::Recording recording = some_recording(1200);
  recording.events.clear();
  recording.tape[300].ticks = 3;     // 301 and 302 are in it and again on their own
  recording.tape[1199].tick = 1250;  // 1199 to 1249 are nowhere
  recording.samples[1199].tick = 1250;
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  produce(recording, channels);
  const RecorderStatistics statistics = recorder.finish("{}");
  EXPECT_EQ(statistics.duplicates, 2);
  EXPECT_EQ(statistics.gaps, 1);
  EXPECT_EQ(load_header(database, recorder.attempt()).is_valid, false) << "nobody vouched for it";
}

}  // namespace

}  // namespace hallux::database
