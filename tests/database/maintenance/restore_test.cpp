#include "database/maintenance/restore.h"
#include "database/store/own_directory.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "database/audit/audit.h"
#include "database/maintenance/backup.h"
#include "database/maintenance/backup_manifest.h"
#include "database/maintenance/erasures.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "simulator/base/progress.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write(const fs::path& file, const std::string& content) {
  std::ofstream{file, std::ios::binary} << content;
}

/// A course with two recordings, and a backup of it in a folder of its own.
class BackedUpCourse : public SomeCourse {
 public:
  BackedUpCourse()
      : SomeCourse(long_name), attempts_{recorded_by("ada"), scored_by("bob", 60'000)} {
    add_note(database(), {attempts_[1], {}, false, "look"}, id_of("kim"));
    backup_ = back_up(database(), folder());
  }

  fs::path folder() const { return place_.data() / "kept"; }
  fs::path manifest() const { return backup_.file; }
  fs::path tables() const { return fs::path{backup_.file}.replace_extension(".tables"); }
  fs::path recording(std::size_t i) const { return recording_file(folder(), attempts_[i]); }
  fs::path target() const { return place_.data() / "again"; }
  const std::vector<AttemptId>& attempts() const noexcept { return attempts_; }

  /// Restoring throws that, and nothing is left.
  void expect_refused(DatabaseErrorKind kind, const std::string& named = "") const {
    try {
      restore({manifest(), target(), {}});
      ADD_FAILURE() << "it was restored";
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), kind) << error.what();
      EXPECT_NE(std::string{error.what()}.find(named), std::string::npos) << error.what();
    }
    expect_nothing_left();
  }

  void expect_nothing_left() const {
    for (const auto& entry : fs::directory_iterator{place_.data()}) {
      EXPECT_EQ(entry.path().filename(), "kept");
    }
  }

 private:
  TemporaryDirectory place_;
  std::vector<AttemptId> attempts_;
  Backup backup_;
};

TEST(Restore, GivesBackAllThatWasThere) {
  BackedUpCourse course;
  const Restored restored = restore({course.manifest(), course.target(), {}});
  EXPECT_EQ(restored.attempts, 2);
  EXPECT_EQ(restored.recordings, 2);
  Database again = Database::open(course.target());
  for (const AttemptId& attempt : course.attempts()) {
    EXPECT_TRUE(
        is_same(load_recording(again, attempt), load_recording(course.database(), attempt)));
  }
  EXPECT_EQ(list_notes(again, course.attempts()[1], true).size(), 1U);
  EXPECT_NO_THROW(sign_in(again, "ada", secret(good_password), cheap));
  EXPECT_EQ(own_directory(again), own_directory(course.database()));
  EXPECT_TRUE(verify(again).is_whole());
  struct stat facts {};
  ASSERT_EQ(::stat(course.target().c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777U, 0700U);
  ASSERT_EQ(::stat((course.target() / "hallux.db").c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777U, 0600U);
}

TEST(Restore, TakesTheNewestOfAFolderAndAnEmptyDirectory) {
  BackedUpCourse course;
  course.recorded_by("ada");
  const Backup newest = back_up(course.database(), course.folder());
  fs::create_directories(course.target());
  const Restored restored = restore({course.folder(), course.target().string() + "/", {}});
  EXPECT_EQ(restored.backup, newest.file);
  EXPECT_EQ(restored.attempts, 3);
}

TEST(Restore, DoesNotPassOverANewestBackupThatIsDamaged) {
  BackedUpCourse course;
  const Backup newest = back_up(course.database(), course.folder());
  write(newest.file, content_of(newest.file) + " ");
  EXPECT_NO_THROW(restore({course.folder(), course.target(), {}})) << "the same JSON";
  fs::remove_all(course.target());
  std::string altered = content_of(newest.file);
  altered.replace(altered.find("\"bytes\": "), 9, "\"bytes\":1");
  write(newest.file, altered);
  EXPECT_EQ(kind_thrown([&] {
              restore({course.folder(), course.target(), {}});
            }),
            DatabaseErrorKind::Damaged);
}

TEST(Restore, CountsAnewWhereNumbersWereGivenBefore) {
  BackedUpCourse course;
  restore({course.manifest(), course.target(), {}});
  Database again = Database::open(course.target());
  const PersonId here = create_person_without_password(course.database(), {"new", "", false});
  EXPECT_EQ(create_person_without_password(again, {"new", "", false}), here);
}

TEST(Restore, BringsNobodyBackWhoWasErased) {
  BackedUpCourse course;
  const PersonId bob = course.id_of("bob");
  erase_person(course.database(), {bob, true, "asked"}, {});
  EXPECT_NE(content_of(course.tables()).find(long_name), std::string::npos);
  const fs::path journal = journal_in(course.database().directory() / "backups");
  const Restored restored = restore({course.manifest(), course.target(), journal});
  EXPECT_EQ(restored.erased_people, 1);
  EXPECT_EQ(content_of(course.target() / "hallux.db").find(long_name), std::string::npos);
  Database again = Database::open(course.target());
  EXPECT_TRUE(is_erased(again, bob));
  EXPECT_EQ(kind_thrown([&] { load_recording(again, course.attempts()[1]); }),
            DatabaseErrorKind::NotFound);
  EXPECT_FALSE(read_journal(journal_in(course.target() / "backups")).empty());
}

TEST(Restore, FindsTheJournalBesideTheBackup) {
  BackedUpCourse course;
  erase_person(course.database(), {course.id_of("bob"), false, "asked"}, {});
  back_up(course.database(), course.folder());
  EXPECT_EQ(restore({course.manifest(), course.target(), {}}).erased_people, 1);
}

TEST(Restore, OfADatabaseInOneFile) {
  BackedUpCourse course;
  const fs::path file = course.folder() / "hallux-20200101-000000.db";
  {
    SQLite::Database source{course.database().file().string(), SQLite::OPEN_READWRITE};
    source.exec("VACUUM INTO '" + file.string() + "'");
  }
  const Restored restored = restore({file, course.target(), {}});
  EXPECT_EQ(restored.attempts, 2);
  EXPECT_EQ(restored.made_utc, "2020-01-01T00:00:00Z");
}

TEST(Restore, OfAnOlderSchemaAppliesTheJournalOfItsOwnFolder) {
  const TemporaryDirectory temporary;
  fs::create_directories(temporary.data() / "kept");
  const fs::path file = temporary.data() / "kept" / "hallux-20200101-000000.db";
  fs::copy_file(fs::path{HALLUX_OLD_DATABASES} / "schema_2.db", file);
  std::int64_t people = 0;
  {
    SQLite::Database old{file.string(), SQLite::OPEN_READONLY};
    people = old.execAndGet("SELECT max(person_id) FROM person").getInt64();
  }
  ASSERT_GT(people, 1);
  const JournalLine line{std::string(32, 'a'), {people}, false, "2026-03-01"};
  add_to_journal(journal_in(file.parent_path()), std::span{&line, 1});
  EXPECT_EQ(restore({file, temporary.data() / "again", {}}).erased_people, 1);
  const JournalLine other{std::string(32, 'b'), {people}, false, "2026-03-01"};
  add_to_journal(journal_in(file.parent_path()), std::span{&other, 1});
  EXPECT_EQ(kind_thrown([&] {
              restore({file, temporary.data() / "once more", {}});
            }),
            DatabaseErrorKind::Refused);
}

TEST(Restore, TouchesNoDirectoryThatHoldsSomething) {
  BackedUpCourse course;
  fs::create_directories(course.target());
  write(course.target() / "mine", "of value");
  EXPECT_EQ(kind_thrown([&] {
              restore({course.manifest(), course.target(), {}});
            }),
            DatabaseErrorKind::Refused);
  EXPECT_EQ(content_of(course.target() / "mine"), "of value");
  fs::remove_all(course.target());
  fs::create_symlink(course.folder(), course.target());
  EXPECT_EQ(kind_thrown([&] {
              restore({course.manifest(), course.target(), {}});
            }),
            DatabaseErrorKind::Refused);
}

TEST(Restore, StoppedAnywhereLeavesNothing) {
  BackedUpCourse course;
  for (const double end : {0.0, 0.2, 0.6, 0.9}) {
    EXPECT_THROW(
        restore({course.manifest(), course.target(), {}}, [&](double part) { return part < end; }),
        Cancelled);
    course.expect_nothing_left();
  }
  EXPECT_EQ(restore({course.manifest(), course.target(), {}}).attempts, 2);
}

TEST(Restore, ClearsWhatAKillLeft) {
  BackedUpCourse course;
  const fs::path left = course.target().parent_path() / ".again.unfinished";
  fs::create_directories(left / "backups");
  write(left / "hallux.db", "half of one");
  EXPECT_EQ(restore({course.manifest(), course.target(), {}}).attempts, 2);
  EXPECT_FALSE(fs::exists(left));
}

TEST(RestoreOfAHostileFolder, NamesTheFileThatWasCut) {
  for (const double share : {0.0, 0.3, 0.99}) {
    BackedUpCourse course;
    for (const fs::path& file : {course.tables(), course.recording(0)}) {
      const std::string whole = content_of(file);
      write(file,
            whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
      course.expect_refused(DatabaseErrorKind::Damaged, file.filename().string());
      write(file, whole);
    }
  }
}

TEST(Restore, EvenDamagedGivesBackWhatIsWholeAndNamesTheRest) {
  BackedUpCourse course;
  fs::resize_file(course.recording(0), 100);
  course.expect_refused(DatabaseErrorKind::Damaged, course.recording(0).filename().string());
  const Restored restored = restore({course.manifest(), course.target(), {}, true});
  ASSERT_TRUE(restored.first_damage);
  EXPECT_NE(restored.first_damage->find(course.recording(0).filename().string()),
            std::string::npos);
  Database again = Database::open(course.target());
  EXPECT_EQ(list_attempts(again).size(), 2U);
  EXPECT_EQ(load_recording(again, course.attempts()[1]).tape.size(), 5U);
  EXPECT_EQ(kind_thrown([&] { load_recording(again, course.attempts()[0]); }),
            DatabaseErrorKind::Damaged);
}

TEST(RestoreOfAHostileFolder, NamesTheFileWithABitThatFlipped) {
  BackedUpCourse course;
  for (const fs::path& file : {course.tables(), course.recording(1), course.manifest()}) {
    const std::string whole = content_of(file);
    for (std::size_t i = 0; i < 12; ++i) {
      std::string flipped = whole;
      flipped[i * (whole.size() - 1) / 11] ^= static_cast<char>(1 << (i % 8));
      if (file == course.manifest() && flipped.back() != whole.back()) continue;
      write(file, flipped);
      try {
        restore({course.manifest(), course.target(), {}});
        ADD_FAILURE() << file << " bit " << i;
      } catch (const DatabaseError& error) {
        EXPECT_NE(std::string{error.what()}.find(file.filename().string()), std::string::npos)
            << error.what();
      }
      course.expect_nothing_left();
    }
    write(file, whole);
  }
}

TEST(RestoreOfAHostileFolder, TakesNoExchangedRecording) {
  BackedUpCourse course;
  fs::copy_file(course.recording(1), course.recording(0), fs::copy_options::overwrite_existing);
  course.expect_refused(DatabaseErrorKind::Damaged, course.recording(0).filename().string());
  // Also where the manifest was written to fit: the seal of the attempt does not.
  BackupManifest manifest = read_manifest(course.manifest());
  std::swap(manifest.recordings[0].bytes, manifest.recordings[1].bytes);
  manifest.recordings[0].digest = manifest.recordings[1].digest;
  manifest.recordings[0].bytes = static_cast<std::int64_t>(fs::file_size(course.recording(0)));
  manifest.recordings[1].bytes = manifest.recordings[0].bytes;
  write_manifest(course.manifest(), manifest);
  course.expect_refused(DatabaseErrorKind::Damaged, "another attempt");
}

TEST(RestoreOfAHostileFolder, MissesARecordingThatTheManifestDoesNotName) {
  BackedUpCourse course;
  BackupManifest manifest = read_manifest(course.manifest());
  manifest.recordings.pop_back();
  write_manifest(course.manifest(), manifest);
  course.expect_refused(DatabaseErrorKind::Damaged, course.attempts()[1].text);
}

TEST(RestoreOfAHostileFolder, FollowsNoPathAndNoLink) {
  BackedUpCourse course;
  BackupManifest manifest = read_manifest(course.manifest());
  const BackupManifest good = manifest;
  manifest.recordings[0].attempt.text = "../../../../../etc/passwd";
  write_manifest(course.manifest(), manifest);
  course.expect_refused(DatabaseErrorKind::Damaged);
  manifest = good;
  manifest.name = "../kept/" + good.name;
  write_manifest(course.manifest(), manifest);
  course.expect_refused(DatabaseErrorKind::Damaged);
  write_manifest(course.manifest(), good);
  for (const fs::path& file : {course.recording(0), course.tables(), course.manifest()}) {
    const fs::path moved = file.string() + ".moved";
    fs::rename(file, moved);
    fs::create_symlink(moved, file);
    course.expect_refused(DatabaseErrorKind::BadInput, file.filename().string());
    fs::remove(file);
    fs::rename(moved, file);
  }
  fs::remove(course.recording(0));
  ASSERT_EQ(::mkfifo(course.recording(0).c_str(), 0600), 0);
  course.expect_refused(DatabaseErrorKind::BadInput, course.recording(0).filename().string());
}

TEST(RestoreOfAHostileFolder, RefusesANewerFormatAndANewerSchema) {
  BackedUpCourse course;
  const std::string good = content_of(course.manifest());
  std::string newer = good;
  newer.replace(newer.find("\"format\": 1"), 11, "\"format\": 9");
  write(course.manifest(), newer);
  course.expect_refused(DatabaseErrorKind::Newer);
  write(course.manifest(), good);
  {
    SQLite::Database tables{course.tables().string(), SQLite::OPEN_READWRITE};
    tables.exec("PRAGMA user_version = 999");
  }
  BackupManifest manifest = read_manifest(course.manifest());
  const std::string bytes = content_of(course.tables());
  manifest.tables = digest_of(std::as_bytes(std::span{bytes.data(), bytes.size()}));
  manifest.tables_bytes = static_cast<std::int64_t>(bytes.size());
  write_manifest(course.manifest(), manifest);
  course.expect_refused(DatabaseErrorKind::Newer);
}

TEST(RestoreOfAHostileFolder, RunsNoTriggerOfAnybodyElse) {
  BackedUpCourse course;
  {
    SQLite::Database tables{course.tables().string(), SQLite::OPEN_READWRITE};
    tables.exec("CREATE TRIGGER mine AFTER INSERT ON chunk BEGIN DELETE FROM note; END");
  }
  BackupManifest manifest = read_manifest(course.manifest());
  const std::string bytes = content_of(course.tables());
  manifest.tables = digest_of(std::as_bytes(std::span{bytes.data(), bytes.size()}));
  manifest.tables_bytes = static_cast<std::int64_t>(bytes.size());
  write_manifest(course.manifest(), manifest);
  course.expect_refused(DatabaseErrorKind::Damaged, "tables are not those");
}

TEST(RestoreOfAHostileFolder, ReadsNoJsonThatIsDeepOrOfAnotherKind) {
  BackedUpCourse course;
  write(course.manifest(), std::string(1'000'000, '['));
  course.expect_refused(DatabaseErrorKind::BadInput);
  write(course.manifest(), R"({"kind":"hallux backup","format":1,"recordings":)" +
                               std::string(200'000, '[') + std::string(200'000, ']') + "}");
  course.expect_refused(DatabaseErrorKind::Damaged);
  write(course.manifest(), R"({"kind":"hallux backup","format":1,"check":7})");
  course.expect_refused(DatabaseErrorKind::Damaged);
}

/// A disk that holds no more than so many bytes of one file, for a process of its own.
int exit_of_restoring_within(const BackedUpCourse& course, rlim_t file_bytes) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{file_bytes, file_bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      restore({course.manifest(), course.target(), {}});
      ::_exit(0);
    } catch (const DatabaseError& error) {
      ::_exit(is_storage_failure(error.kind()) ? 6 : 3);
    } catch (...) {
      ::_exit(1);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Restore, OnAFullDiskLeavesNothing) {
  const BackedUpCourse course;
  const auto bytes = static_cast<rlim_t>(fs::file_size(course.tables()));
  for (const rlim_t limit : {rlim_t{1000}, bytes / 2, bytes - 5000}) {
    EXPECT_EQ(exit_of_restoring_within(course, limit), 6) << limit;
    course.expect_nothing_left();
  }
}

}  // namespace

}  // namespace hallux::database
