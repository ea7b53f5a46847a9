#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "database/course/begin_attempt.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "tests/database/some_database.h"
#include "tests/support/faulty_vfs.h"

namespace hallux::database {

namespace {

OpenOptions through(const tests::FaultyVfs& vfs) { return {Access::ReadWrite, 200, vfs.name()}; }

DatabaseErrorKind kind_of_opening(const std::filesystem::path& directory,
                                  const OpenOptions& options) {
  try {
    Database::open(directory, options);
  } catch (const DatabaseError& error) {
    EXPECT_NE(std::string{error.what()}.find("hallux.db"), std::string::npos) << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "the database was opened";
  return DatabaseErrorKind::BadInput;
}

TEST(StorageFailure, AFullDiskAtTheFirstOpeningIsSaidAndMended) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"full_at_first"};
  // Wherever in making the file the space ends, the next opening with space finds or makes a whole
  // one.
  for (int writes = 0; writes < 12; ++writes) {
    vfs.fail_after(writes, SQLITE_FULL);
    EXPECT_EQ(kind_of_opening(temporary.data(), through(vfs)), DatabaseErrorKind::Full) << writes;
  }
  vfs.heal();
  Database database = Database::open(temporary.data(), through(vfs));
  EXPECT_TRUE(verify(database).is_whole());
}

TEST(StorageFailure, AReadOnlyFileIsSaid) {
  const TemporaryDirectory temporary;
  { Database::open(temporary.data()); }
  tests::FaultyVfs vfs{"read_only"};
  vfs.make_read_only(true);
  EXPECT_EQ(kind_of_opening(temporary.data(), through(vfs)), DatabaseErrorKind::ReadOnly);
}

struct Failure {
  int code;
  DatabaseErrorKind kind;
};

class FailureWhileRecording : public testing::TestWithParam<Failure> {};

TEST_P(FailureWhileRecording, StopsTheRecorderAndKeepsWhatWasCommitted) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"while_recording"};
  const simulator::Recording recording = some_recording(4000);
  Database database = Database::open(temporary.data(), through(vfs));
  const AttemptId older = record(database, some_attempt(database), recording);
  AttemptId failed;
  {
    simulator::AttemptChannels channels;
    Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
    failed = recorder.attempt();
    vfs.fail_after(9, GetParam().code);
    produce(recording, channels);
    try {
      recorder.finish("{}");
      ADD_FAILURE() << "the recorder went on";
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), GetParam().kind) << error.what();
      EXPECT_NE(std::string{error.what()}.find(failed.text), std::string::npos) << error.what();
    }
    EXPECT_TRUE(channels.recorder_failed.load());
  }
  vfs.heal();
  Database healed = Database::open(temporary.data(), through(vfs));
  EXPECT_TRUE(is_same(load_recording(healed, older), recording));
  EXPECT_EQ(load_header(healed, failed).state, AttemptState::Interrupted);
  const simulator::Recording rest = load_recording(healed, failed);
  EXPECT_EQ(rest.samples.size() % static_cast<std::size_t>(window_ticks), 0U);
  EXPECT_EQ(rest.tape.size(), rest.samples.size());
  EXPECT_TRUE(std::equal(rest.samples.begin(), rest.samples.end(), recording.samples.begin()));
  EXPECT_TRUE(verify(healed).is_whole());
}

INSTANTIATE_TEST_SUITE_P(StorageFailure, FailureWhileRecording,
                         testing::Values(Failure{SQLITE_FULL, DatabaseErrorKind::Full},
                                         Failure{SQLITE_IOERR_SHMSIZE, DatabaseErrorKind::Full},
                                         Failure{SQLITE_READONLY, DatabaseErrorKind::ReadOnly},
                                         Failure{SQLITE_IOERR_WRITE,
                                                 DatabaseErrorKind::InputOutput}));

/// Some seconds at most; the recorder tries again five times a second.
bool becomes(const std::atomic<bool>& flag, bool expected) {
  for (int i = 0; i < 1000 && flag.load() != expected; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
  return flag.load() == expected;
}

TEST(StorageFailure, AFullDiskIsWaitedForAndNothingIsLost) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"waited_for"};
  const simulator::Recording recording = some_recording(4000);
  Database database = Database::open(temporary.data(), through(vfs));
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels,
                    FullDisk::IsWaitedFor};
  vfs.fail_after(5, SQLITE_FULL);
  produce(recording, channels);
  ASSERT_TRUE(becomes(channels.storage_full, true));
  EXPECT_FALSE(channels.recorder_failed.load());
  vfs.heal();
  ASSERT_TRUE(becomes(channels.storage_full, false));
  const RecorderStatistics statistics = recorder.finish("{\"complete\": true}");
  EXPECT_EQ(statistics.samples, 4000);
  EXPECT_EQ(statistics.commits, 8);
  EXPECT_TRUE(is_same(load_recording(database, recorder.attempt()), recording));
  EXPECT_EQ(load_header(database, recorder.attempt()).state, AttemptState::Closed);
  EXPECT_TRUE(verify(database).is_whole());
}

TEST(StorageFailure, SealingWaitsForAFullDiskToo) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"sealing_waits"};
  Database database = Database::open(temporary.data(), through(vfs));
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels,
                    FullDisk::IsWaitedFor};
  produce(some_recording(700), channels);
  recorder.drain();
  vfs.fail_after(0, SQLITE_FULL);
  const std::jthread somebody_with_a_broom{[&] {
    becomes(channels.storage_full, true);
    vfs.heal();
  }};
  recorder.finish("{}");
  EXPECT_EQ(load_header(database, recorder.attempt()).state, AttemptState::Closed);
}

TEST(StorageFailure, WhoGivesUpOnAFullDiskKeepsWhatWasCommitted) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"given_up"};
  Database database = Database::open(temporary.data(), through(vfs));
  AttemptId id;
  {
    simulator::AttemptChannels channels;
    Recorder recorder{database, create_attempt(database, some_attempt(database)), channels,
                      FullDisk::IsWaitedFor};
    id = recorder.attempt();
    vfs.fail_after(5, SQLITE_FULL);
    produce(some_recording(4000), channels);
    ASSERT_TRUE(becomes(channels.storage_full, true));
    channels.gives_up.store(true);
    try {
      recorder.drain();
      ADD_FAILURE() << "the recorder went on";
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::Full) << error.what();
    }
    EXPECT_TRUE(channels.recorder_failed.load());
  }
  vfs.heal();
  Database healed = Database::open(temporary.data(), through(vfs));
  EXPECT_EQ(load_header(healed, id).state, AttemptState::Interrupted);
  EXPECT_EQ(load_recording(healed, id).samples.size() % 500, 0U);
}

TEST(StorageFailure, ARecorderThatGoesAwayDoesNotWaitForAFullDisk) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"goes_away"};
  Database database = Database::open(temporary.data(), through(vfs));
  simulator::AttemptChannels channels;
  {
    const Recorder recorder{database, create_attempt(database, some_attempt(database)), channels,
                            FullDisk::IsWaitedFor};
    vfs.fail_after(0, SQLITE_FULL);
    produce(some_recording(700), channels);
    ASSERT_TRUE(becomes(channels.storage_full, true));
  }
  EXPECT_TRUE(channels.recorder_failed.load());
}

TEST(StorageFailure, OnlyAFullDiskIsWaitedFor) {
  for (const int code : {SQLITE_READONLY, SQLITE_IOERR_WRITE}) {
    const TemporaryDirectory temporary;
    tests::FaultyVfs vfs{"not_waited_for"};
    Database database = Database::open(temporary.data(), through(vfs));
    simulator::AttemptChannels channels;
    Recorder recorder{database, create_attempt(database, some_attempt(database)), channels,
                      FullDisk::IsWaitedFor};
    vfs.fail_after(0, code);
    produce(some_recording(700), channels);
    EXPECT_THROW(recorder.drain(), DatabaseError);
    EXPECT_FALSE(channels.storage_full.load());
    EXPECT_TRUE(channels.recorder_failed.load());
  }
}

TEST(StorageFailure, AWriterThatKeepsTheFileBusyIsSaid) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"busy"};
  Database database = Database::open(temporary.data(), {Access::ReadWrite, 20, ""});
  const NewAttempt attempt = some_attempt(database);
  SQLite::Database other{database.file().string(), SQLite::OPEN_READWRITE};
  other.exec("BEGIN IMMEDIATE");
  try {
    create_attempt(database, attempt);
    ADD_FAILURE() << "two wrote at once";
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::Locked) << error.what();
  }
}

}  // namespace

}  // namespace hallux::database
