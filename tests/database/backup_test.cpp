#include "database/backup.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <span>

#include "database/assets.h"
#include "database/attempts.h"
#include "database/verify.h"
#include "tests/database/some_database.h"

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

/// What a backup holds when it is put in the place of a database.
Verification restored(const fs::path& file, const fs::path& directory) {
  fs::create_directories(directory);
  fs::copy_file(file, directory / "hallux.db");
  Database database = Database::open(directory);
  return verify(database);
}

std::size_t file_count(const fs::path& directory) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator{directory}, fs::directory_iterator{}));
}

TEST(Backup, HoldsAllThatWasCommitted) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  record(database, some_attempt(database), some_recording(1200));
  const Backup backup = back_up(database, temporary.data() / "backups");
  EXPECT_EQ(file_count(temporary.data() / "backups"), 1U) << "one file, no log beside it";
  const Verification found = restored(backup.file, temporary.data() / "again");
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.attempts, 1);
  EXPECT_EQ(found.chunks, 9);
}

TEST(Backup, IsForItsOwnerOnly) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const Backup backup = back_up(database, temporary.data() / "backups");
  struct stat facts {};
  ASSERT_EQ(::stat(backup.file.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777U, 0600U);
  ASSERT_EQ(::stat((temporary.data() / "backups").c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777U, 0700U);
}

TEST(Backup, GoesOnWhileAnotherConnectionWrites) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  fill(database);
  int reports = 0;
  Database writer = database.open_again();
  const NewAttempt attempt = some_attempt(writer);
  const Backup backup = back_up(database, temporary.data() / "backups", [&](double) {
    record(writer, attempt, some_recording(5));
    return ++reports < 1000;
  });
  EXPECT_GE(reports, 4);
  EXPECT_LT(reports, 20) << "a commit must not begin the copy anew";
  const Verification found = restored(backup.file, temporary.data() / "again");
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.attempts, 0) << "as it was when the backup began";
  EXPECT_EQ(list_attempts(database).size(), static_cast<std::size_t>(reports));
}

TEST(Backup, StoppedLeavesNothing) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  fill(database);
  double last = 0.0;
  EXPECT_THROW(back_up(database, temporary.data() / "backups",
                       [&](double part) {
                         EXPECT_GE(part, last);
                         last = part;
                         return part < 0.4;
                       }),
               BackupStopped);
  EXPECT_GE(last, 0.4);
  EXPECT_EQ(file_count(temporary.data() / "backups"), 0U);
}

TEST(Backup, OverwritesNoOther) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  database.pretend_it_is("2026-03-01T14:25:07.000Z");
  const Backup first = back_up(database, temporary.data() / "backups");
  const Backup second = back_up(database, temporary.data() / "backups");
  EXPECT_EQ(first.file.filename(), "hallux-20260301-142507.db");
  EXPECT_NE(first.file, second.file);
}

TEST(Backup, CopiesIntoADatabaseThatIsOpen) {
  const TemporaryDirectory temporary;
  Database source = Database::open(temporary.data() / "from");
  record(source, some_attempt(source), some_recording(5));
  Database target = Database::open(temporary.data() / "to");
  Database reader = target.open_again();
  EXPECT_TRUE(list_attempts(reader).empty());
  copy_whole(source, target);
  EXPECT_EQ(list_attempts(reader).size(), 1U);
  EXPECT_TRUE(verify(reader).is_whole());
}

}  // namespace

}  // namespace hallux::database
