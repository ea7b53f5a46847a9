#include "database/maintenance/backup.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <array>
#include <fstream>
#include <thread>

#include "database/content/assets.h"
#include "database/course/begin_attempt.h"
#include "database/maintenance/backup_manifest.h"
#include "database/maintenance/backup_rotation.h"
#include "database/maintenance/restore.h"
#include "database/maintenance/verify.h"
#include "database/recording/erased_recordings.h"
#include "database/recording/recordings.h"
#include "database/store/settings.h"
#include "simulator/base/progress.h"
#include "tests/database/some_course.h"
#include "tests/support/faulty_vfs.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// Larger than what is copied between two reports.
void fill(Database& database) {
  for (int i = 0; i < 8; ++i) {
    std::string bytes(2U << 20U, '\0');
    std::uint64_t random = 88172645463325252ULL + static_cast<std::uint64_t>(i);
    for (char& byte : bytes) {
      random ^= random << 13U;
      random ^= random >> 7U;
      random ^= random << 17U;
      byte = static_cast<char>(random);
    }
    put_asset(database, "bone", std::as_bytes(std::span{bytes.data(), bytes.size()}));
  }
}

fs::path backups_of(const Database& database) { return database.directory() / "backups"; }

/// Files of backups, without the lock and the folder of recordings.
std::size_t file_count(const fs::path& folder) {
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder}) {
    count += entry.is_regular_file() && entry.path().filename() != ".lock" ? 1 : 0;
  }
  return count;
}

std::size_t recording_count(const fs::path& folder) {
  const fs::directory_iterator entries{folder / "recordings"};
  return static_cast<std::size_t>(std::distance(entries, fs::directory_iterator{}));
}

AttemptId record_some(Database& database, std::int64_t ticks) {
  return record(database, some_attempt(database), some_recording(ticks));
}

/// What a backup holds when it is a data directory again.
Verification restored(const fs::path& file, const fs::path& directory) {
  restore({file, directory, {}});
  Database database = Database::open(directory);
  return verify(database);
}

TEST(Backup, HoldsAllThatWasCommitted) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record_some(database, 1200);
  const Backup backup = back_up(database, backups_of(database));
  EXPECT_EQ(backup.recordings, 1);
  EXPECT_EQ(file_count(backups_of(database)), 3U) << "manifest, tables, journal; no log beside";
  EXPECT_EQ(recording_count(backups_of(database)), 1U);
  const Verification found = restored(backup.file, temporary.data().parent_path() / "again");
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.attempts, 1);
  EXPECT_EQ(found.chunks, 9);
}

TEST(Backup, WritesARecordingOnceAndNamesItInEveryManifest) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId first = record_some(database, 4000);
  const Backup one = back_up(database, backups_of(database));
  const fs::path kept = recording_file(backups_of(database), first);
  const auto written = fs::last_write_time(kept);
  record_some(database, 600);
  const Backup two = back_up(database, backups_of(database));
  EXPECT_EQ(fs::last_write_time(kept), written);
  EXPECT_EQ(recording_count(backups_of(database)), 2U);
  EXPECT_EQ(read_manifest(two.file).recordings.front(), read_manifest(one.file).recordings.front());
  EXPECT_GT(two.bytes, one.bytes);
  EXPECT_LT(two.new_bytes, two.bytes - read_manifest(one.file).recordings.front().bytes + 1);
}

TEST(Backup, IsForItsOwnerOnly) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record_some(database, 5);
  const Backup backup = back_up(database, backups_of(database));
  for (const auto& entry : fs::recursive_directory_iterator{backups_of(database)}) {
    struct stat facts {};
    ASSERT_EQ(::stat(entry.path().c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, entry.is_directory() ? 0700U : 0600U) << entry.path();
  }
}

TEST(Backup, GoesOnWhileAnotherConnectionWrites) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  fill(database);
  int reports = 0, recorded = 0;
  Database writer = database.open_again();
  const NewAttempt attempt = some_attempt(writer);
  const Backup backup = back_up(database, backups_of(database), {[&](double part) {
                                  if (part > 0.5 && recorded < 5) {
                                    record(writer, attempt, some_recording(5));
                                    ++recorded;
                                  }
                                  return ++reports < 1000;
                                }});
  EXPECT_GE(reports, 4);
  EXPECT_LT(reports, 200) << "a commit must not begin the copy anew";
  const Verification found = restored(backup.file, temporary.data().parent_path() / "again");
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_LT(found.attempts, recorded) << "as it was at the snapshot";
  EXPECT_EQ(list_attempts(database).size(), static_cast<std::size_t>(recorded));
}

TEST(Backup, TakesAnAttemptThatIsBeingRecordedUpToItsLastWindow) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  simulator::AttemptChannels channels{4096};
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  const simulator::Recording recording = some_recording(2200);
  produce(recording, channels);
  const AttemptId running = recorder.attempt();
  Database reader = database.open_again();
  while (check_recording(reader, running) < 4 * 3 - 1) std::this_thread::yield();
  const Backup backup = back_up(database, backups_of(database));
  recorder.finish("{}");
  EXPECT_EQ(load_header(database, running).state, AttemptState::Closed);
  const fs::path directory = temporary.data().parent_path() / "again";
  restore({backup.file, directory, {}});
  Database again = Database::open(directory);
  EXPECT_EQ(load_header(again, running).state, AttemptState::Interrupted);
  EXPECT_GE(load_recording(again, running).tape.size(), 2000U);
}

TEST(Backup, StoppedLeavesNothing) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record_some(database, 5);
  fill(database);
  for (const double end : {0.0, 0.5, 0.7, 0.95}) {
    double last = 0.0;
    EXPECT_THROW(back_up(database, backups_of(database), {[&](double part) {
                           EXPECT_GE(part, last);
                           last = part;
                           return part < end;
                         }}),
                 Cancelled);
    EXPECT_TRUE(list_backups(backups_of(database)).empty());
    EXPECT_LE(file_count(backups_of(database)), 1U) << end;
  }
  EXPECT_NO_THROW(back_up(database, backups_of(database)));
}

TEST(Backup, TwoOnOneDayAreTwo) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  database.pretend_it_is("2026-03-01T14:25:07.000Z");
  const Backup first = back_up(database, backups_of(database));
  const Backup second = back_up(database, backups_of(database));
  EXPECT_EQ(first.file.filename(), "hallux-20260301-142507.json");
  EXPECT_EQ(second.file.filename(), "hallux-20260301-142507-2.json");
  const std::vector<Backup> listed = list_backups(backups_of(database));
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_EQ(listed[0].made_utc, "2026-03-01T14:25:07Z");
  EXPECT_EQ(listed[0].bytes, listed[1].bytes);
}

TEST(Backup, IsSkippedWithAWordWhereTwiceItsSizeIsNotFree) {
  SomeCourse course;
  const fs::path folder = backups_of(course.database());
  EXPECT_EQ(kind_thrown([&] {
              back_up_with_rotation(course.database(), folder, course.id_of("root"), {{}, 1000});
            }),
            DatabaseErrorKind::Full);
  EXPECT_TRUE(list_backups(folder).empty());
  const AuditEntry last = course.last_audit();
  EXPECT_EQ(last.action, "backup_made");
  EXPECT_TRUE(last.was_refused);
  EXPECT_EQ(course.sign_in_as("root").notices().front().kind, NoticeKind::BackupSkipped);
}

TEST(Backup, ByAFullDiskIsNoneAndTheNextIsWhole) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"full_backup"};
  Database database = Database::open(temporary.data(), {Access::ReadWrite, 200, vfs.name()});
  record_some(database, 600);
  for (const int writes : {0, 1, 5, 20}) {
    vfs.fail_after(writes, SQLITE_FULL);
    EXPECT_EQ(kind_thrown([&] { back_up(database, backups_of(database)); }),
              DatabaseErrorKind::Full)
        << writes;
    vfs.heal();
    EXPECT_TRUE(list_backups(backups_of(database)).empty());
  }
  const Backup backup = back_up(database, backups_of(database));
  EXPECT_TRUE(restored(backup.file, temporary.data().parent_path() / "again").is_whole());
}

TEST(Backup, KeepsWhatWasDamagedBeforeAsItIsAndSaysSo) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId damaged = record_some(database, 600);
  record_some(database, 5);
  tamper(database, "UPDATE chunk SET link = zeroblob(32) WHERE attempt_id = 1 AND stream = 1");
  const Backup backup = back_up(database, backups_of(database));
  EXPECT_EQ(backup.damaged, 1);
  EXPECT_EQ(backup.recordings, 1);
  EXPECT_FALSE(fs::exists(recording_file(backups_of(database), damaged)));
  EXPECT_EQ(kind_thrown([&] {
              restore({backup.file, temporary.data() / "again", {}});
            }),
            DatabaseErrorKind::Damaged);
}

TEST(Backup, HoldsNoChunksOfAnErasedRecording) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const AttemptId erased = record_some(database, 600);
  back_up(database, backups_of(database));
  erase_recording(database, erased, std::nullopt);
  const Backup backup = back_up(database, backups_of(database));
  EXPECT_EQ(backup.recordings, 0);
  EXPECT_TRUE(restored(backup.file, temporary.data().parent_path() / "again").is_whole());
}

TEST(Backup, CopiesIntoADatabaseThatIsOpen) {
  const TemporaryDirectory temporary;
  Database source = Database::open(temporary.data() / "from");
  record_some(source, 5);
  Database target = Database::open(temporary.data() / "to");
  Database reader = target.open_again();
  EXPECT_TRUE(list_attempts(reader).empty());
  copy_whole(source, target);
  EXPECT_EQ(list_attempts(reader).size(), 1U);
  EXPECT_TRUE(verify(reader).is_whole());
}

TEST(Rotation, KeepsTheNewestAndOneOfEachDayWeekAndMonth) {
  const std::array<std::string, 8> made{"2026-03-04T18:00:00Z", "2026-03-04T09:00:00Z",
                                        "2026-03-03T18:00:00Z", "2026-03-02T18:00:00Z",
                                        "2026-03-01T18:00:00Z", "2026-02-27T18:00:00Z",
                                        "2026-02-01T18:00:00Z", "2026-01-15T18:00:00Z"};
  EXPECT_EQ(kept_by({1, 0, 0, 0}, made),
            (std::vector<bool>{true, false, false, false, false, false, false, false}));
  EXPECT_EQ(kept_by({2, 0, 0, 0}, made),
            (std::vector<bool>{true, true, false, false, false, false, false, false}));
  EXPECT_EQ(kept_by({1, 2, 0, 0}, made),
            (std::vector<bool>{true, false, true, false, false, false, false, false}));
  // The 1st of March 2026 is a Sunday: it is the newest of the week before.
  EXPECT_EQ(kept_by({1, 0, 2, 0}, made),
            (std::vector<bool>{true, false, false, false, true, false, false, false}));
  EXPECT_EQ(kept_by({1, 0, 0, 3}, made),
            (std::vector<bool>{true, false, false, false, false, true, false, true}));
  EXPECT_TRUE(kept_by({1, 1, 1, 1}, {}).empty());
}

TEST(Rotation, RemovesBackupsAndLastWhatNoManifestNames) {
  SomeCourse course;
  Database& database = course.database();
  const fs::path folder = backups_of(database);
  const AttemptId attempt = course.recorded_by("ada");
  store_setting(database, "backups_newest", "1");
  for (const char* period : {"backups_days", "backups_weeks", "backups_months"})
    store_setting(database, period, "0");
  database.pretend_it_is("2026-03-01T14:25:07.000Z");
  const Backup first = back_up_with_rotation(database, folder, {});
  erase_recording(database, attempt, std::nullopt);
  EXPECT_EQ(recording_count(folder), 1U);
  database.pretend_it_is("2026-03-02T14:25:07.000Z");
  const Backup second = back_up_with_rotation(database, folder, {});
  ASSERT_EQ(list_backups(folder).size(), 1U);
  EXPECT_EQ(list_backups(folder).front().file, second.file);
  EXPECT_EQ(recording_count(folder), 0U);
  EXPECT_FALSE(fs::exists(fs::path{first.file}.replace_extension(".tables")));
  EXPECT_EQ(course.last_audit().action, "backup_removed");
  EXPECT_EQ(course.last_audit().text, "hallux-20260301-142507.json");
}

TEST(Rotation, TouchesNothingOfAnotherDirectoryAndNoRecordingWhileAManifestIsUnreadable) {
  const TemporaryDirectory temporary;
  Database one = Database::open(temporary.data() / "one");
  Database two = Database::open(temporary.data() / "two");
  const fs::path folder = temporary.data() / "together";
  const AttemptId gone = record_some(one, 5);
  back_up(one, folder);
  back_up(two, folder);
  erase_recording(one, gone, std::nullopt);
  back_up(one, folder);
  std::ofstream{folder / "hallux-20200101-000000.json"} << "{";
  EXPECT_EQ(rotate_backups(one, folder, {1, 0, 0, 0}).size(), 1U);
  EXPECT_EQ(list_backups(folder).size(), 2U);
  EXPECT_EQ(recording_count(folder), 1U);
  fs::remove(folder / "hallux-20200101-000000.json");
  EXPECT_TRUE(rotate_backups(one, folder, {1, 0, 0, 0}).empty());
  EXPECT_EQ(recording_count(folder), 0U);
}

TEST(Rotation, IsAsTheSettingsSayWithinItsBounds) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  EXPECT_EQ(load_rotation(database).newest, 10);
  store_setting(database, "backups_newest", "0");
  store_setting(database, "backups_months", "5000");
  EXPECT_EQ(load_rotation(database).newest, 1);
  EXPECT_EQ(load_rotation(database).months, 1000);
}

}  // namespace

}  // namespace hallux::database
