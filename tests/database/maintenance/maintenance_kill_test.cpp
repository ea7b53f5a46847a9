/// Backup, restore, erasure and retention, killed at every report of their progress and at moments
/// in between: nothing half is left, and once more completes it.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>

#include "database/maintenance/backup.h"
#include "database/maintenance/erasures.h"
#include "database/maintenance/restore.h"
#include "database/maintenance/retention.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "simulator/base/progress.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// Runs `work` in a process of its own and kills it at that report, or after that time; true where
/// it ended before.
bool ended_before_kill(const std::function<void(const Progress&)>& work, int report,
                       std::chrono::microseconds after) {
  const pid_t child = ::fork();
  if (child == 0) {
    int reports = 0;
    try {
      work([&](double) {
        if (++reports == report) ::kill(::getpid(), SIGKILL);
        return true;
      });
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  if (report == 0) {
    std::this_thread::sleep_for(after);
    ::kill(child, SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
  return WIFEXITED(status);
}

/// At each report until one run ends by itself, then at 20 moments of its course; `check` after
/// each kill.
void kill_everywhere(const std::function<void(const Progress&)>& work,
                     const std::function<void()>& check) {
  const auto begin = std::chrono::steady_clock::now();
  int report = 1;
  for (; report < 500 && !ended_before_kill(work, report, {}); report += 1 + report / 8) check();
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(
      (std::chrono::steady_clock::now() - begin) / report);
  check();
  for (int i = 0; i < 20; ++i) {
    ended_before_kill(work, 0, whole * i / 15);
    check();
  }
}

/// Three recordings of ada's in the data directory `at`.
void fill(const fs::path& at) {
  Database database = Database::open(at);
  OpenHouse::enter(database)->add_first_administrator({"root", "", true}, secret(good_password),
                                                      cheap);
  const PersonId ada =
      create_person(database, {"ada", "zelda", false}, secret(good_password), cheap);
  NewAttempt attempt = some_attempt(database);
  attempt.person = ada;
  attempt.hand = "";
  for (int i = 0; i < 3; ++i) record(database, attempt, some_recording(1200));
}

Database expect_whole(const fs::path& at) {
  Database database = Database::open(at);
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  return database;
}

TEST(KillWhileKeeping, ABackupThatIsListedIsWhole) {
  const TemporaryDirectory temporary;
  fill(temporary.data());
  const fs::path folder = temporary.data() / "backups", again = temporary.data() / "again";
  std::size_t complete = 0;
  kill_everywhere(
      [&](const Progress& progress) {
        Database database = Database::open(temporary.data());
        back_up(database, folder, {progress, {}});
      },
      [&] {
        const std::vector<Backup> backups = list_backups(folder);
        EXPECT_GE(backups.size(), complete);
        if (backups.size() == complete) return;
        complete = backups.size();
        EXPECT_EQ(restore({backups.front().file, again, {}}).attempts, 3);
        fs::remove_all(again);
      });
  EXPECT_GT(complete, 0U);
  Database database = expect_whole(temporary.data());
  restore({back_up(database, folder).file, again, {}});
  expect_whole(again);
}

TEST(KillWhileKeeping, ARestoredDirectoryIsWholeOrNotThere) {
  const TemporaryDirectory temporary;
  fill(temporary.data());
  const fs::path folder = temporary.data() / "backups", again = temporary.data() / "again";
  {
    Database database = Database::open(temporary.data());
    back_up(database, folder);
  }
  kill_everywhere(
      [&](const Progress& progress) {
        restore({folder, again, {}}, progress);
      },
      [&] {
        if (!fs::exists(again)) return;
        Database database = expect_whole(again);
        EXPECT_EQ(list_attempts(database).size(), 3U);
        fs::remove_all(again);
      });
  EXPECT_EQ(restore({folder, again, {}}).attempts, 3);
  for (const auto& entry : fs::directory_iterator{temporary.data()}) {
    EXPECT_EQ(entry.path().filename().string().find("unfinished"), std::string::npos);
  }
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(KillWhileKeeping, APersonIsErasedOrThereWithEverything) {
  const TemporaryDirectory temporary;
  const fs::path original = temporary.data() / "original", copy = temporary.data() / "copy";
  fill(original);
  const auto erase = [&](const Progress& progress) {
    Database database = Database::open(copy);
    const std::optional<Person> ada = known_person(database, "ada");
    if (ada) erase_person(database, {ada->id, true, "asked"}, {}, progress);
  };
  fs::copy(original, copy, fs::copy_options::recursive);
  kill_everywhere(erase, [&] {
    {
      Database database = expect_whole(copy);
      const std::optional<Person> ada = known_person(database, "ada");
      if (ada) {
        EXPECT_TRUE(ada->has_password);
        EXPECT_EQ(ada->display_name, "zelda");
        erase({});
      } else {
        clear_log(database);
      }
    }
    EXPECT_EQ(content_of(copy / "hallux.db").find("zelda"), std::string::npos);
    fs::remove_all(copy);
    fs::copy(original, copy, fs::copy_options::recursive);
  });
}

TEST(KillWhileKeeping, ARecordingWentOrIsThere) {
  const TemporaryDirectory temporary;
  const fs::path original = temporary.data() / "original", copy = temporary.data() / "copy";
  fill(original);
  {
    Database database = Database::open(original);
    store_retention(database, {1, {}, {}, {}});
  }
  const auto retain = [&](const Progress& progress) {
    Database database = Database::open(copy);
    database.pretend_it_is("2099-01-01T00:00:00.000Z");
    apply_retention(database, {}, progress);
  };
  fs::copy(original, copy, fs::copy_options::recursive);
  kill_everywhere(retain, [&] {
    expect_whole(copy);
    retain({});
    Database database = expect_whole(copy);
    EXPECT_TRUE(plan_retention(database).empty());
    fs::remove_all(copy);
    fs::copy(original, copy, fs::copy_options::recursive);
  });
}

}  // namespace

}  // namespace hallux::database
