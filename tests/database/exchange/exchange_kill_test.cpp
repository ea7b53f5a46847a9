/// Export and import, killed at moments spread over their course: what has its name is whole, and
/// once more completes it.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "database/exchange/export_attempt.h"
#include "database/exchange/import_attempt.h"
#include "database/maintenance/verify.h"
#include "database/people/people.h"
#include "database/store/fresh_directory.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

constexpr int kills = 30, attempts = 4;
constexpr const char* password = "a long enough phrase";

std::vector<DerivedFile> a_mesh(const ExportMaterial&) { return {{"bone.ply", "as if it were"}}; }

/// In a process of its own, killed after that time where it has not ended by then.
void run_and_kill(const std::function<void()>& work, std::chrono::microseconds after) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      work();
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  std::this_thread::sleep_for(after);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
}

/// At moments spread over what one undisturbed run takes, each run in a place of its own, by
/// number; `check` after each.
void kill_everywhere(const std::function<void(int)>& work, const std::function<void(int)>& check) {
  const auto begin = std::chrono::steady_clock::now();
  work(0);
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - begin);
  check(0);
  for (int run = 1; run <= kills; ++run) {
    run_and_kill([&] { work(run); }, whole * run / (kills * 3 / 4));
    check(run);
  }
}

std::vector<AttemptId> fill(Database& database) {
  std::vector<AttemptId> ids(attempts);
  for (AttemptId& id : ids) id = record(database, some_attempt(database), some_recording(1200));
  return ids;
}

void export_all(const fs::path& data, const std::vector<AttemptId>& ids, const fs::path& target) {
  Database database = Database::open(data);
  const FreshDirectory fresh(target);
  for (const AttemptId& id : ids) export_attempt(database, id, fresh.path(), a_mesh);
  fresh.finish();
}

TEST(KillWhileExchanging, AnExportThatHasItsNameIsWhole) {
  const TemporaryDirectory temporary;
  std::vector<AttemptId> ids;
  {
    Database database = Database::open(temporary.data());
    ids = fill(database);
  }
  const auto target = [&](int run) { return temporary.data() / ("out-" + std::to_string(run)); };
  kill_everywhere([&](int run) { export_all(temporary.data(), ids, target(run)); },
                  [&](int run) {
                    if (!fs::exists(target(run))) return;
                    const std::vector<fs::path> folders = find_exported(target(run));
                    EXPECT_EQ(folders.size(), ids.size());
                    for (const fs::path& folder : folders) EXPECT_NO_THROW(read_exported(folder));
                  });
  EXPECT_TRUE(fs::exists(target(0)));
}

TEST(KillWhileExchanging, AnAttemptIsTakenInWhollyOrNotAtAll) {
  const TemporaryDirectory from, into;
  const fs::path target = from.data() / "out";
  std::vector<ImportedAttempt> exported;
  {
    Database database = Database::open(from.data());
    const std::vector<AttemptId> ids = fill(database);
    export_all(from.data(), ids, target);
    for (const AttemptId& id : ids) exported.push_back(read_exported(target / id.text));
  }
  ScoreCard card;
  card.score_milli = 1000;
  const auto place = [&](int run) { return into.data().parent_path() / std::to_string(run); };
  const auto import_all = [&](int run) {
    Database database = Database::open(place(run));
    const PersonId by = create_person(database, {"chief", "", false}, secret(password), cheap);
    for (const ImportedAttempt& attempt : exported) store_imported(database, attempt, card, by);
  };
  kill_everywhere(import_all, [&](int run) {
    Database database = Database::open(place(run));
    const std::vector<AttemptHeader> here = list_attempts(database);
    EXPECT_TRUE(run > 0 || here.size() == exported.size());
    for (const AttemptHeader& header : here) {
      EXPECT_EQ(header.state, AttemptState::Closed);
      EXPECT_EQ(header.score_milli, 1000);
    }
    const Verification found = verify(database);
    EXPECT_TRUE(found.is_whole()) << found.first_damage.value_or("");
  });
}

}  // namespace

}  // namespace hallux::database
