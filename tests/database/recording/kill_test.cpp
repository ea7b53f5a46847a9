#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "database/course/begin_attempt.h"
#include "database/maintenance/verify.h"
#include "database/recording/display_facts.h"
#include "database/recording/recordings.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

/// Records at a thousand ticks a second until it is killed. Never returns.
[[noreturn]] void record_until_killed(const std::filesystem::path& directory, int ready) {
  Database database = Database::open(directory);
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  const simulator::Recording recording = some_recording(60'000);
  const auto facts = some_display_facts(60'000);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < recording.tape.size(); ++i) {
    std::this_thread::sleep_until(start + std::chrono::milliseconds{i});
    if (i % 100 == 0) channels.display_facts.push(facts[i / 100]);
    channels.tape.push(recording.tape[i]);
    channels.samples.push(recording.samples[i]);
    const auto tick = static_cast<std::int32_t>(i);
    if (::write(ready, &tick, sizeof tick) != sizeof tick) break;
  }
  ::_exit(1);
}

/// Kills a recording child once it has pushed `ticks`; returns how many it had pushed when it died.
std::int32_t kill_after(const std::filesystem::path& directory, std::int32_t ticks) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) record_until_killed(directory, ends[1]);
  ::close(ends[1]);
  std::int32_t pushed = 0;
  while (pushed < ticks && ::read(ends[0], &pushed, sizeof pushed) == sizeof pushed) {
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  while (::read(ends[0], &pushed, sizeof pushed) == sizeof pushed) {
  }
  ::close(ends[0]);
  return pushed + 1;
}

/// Of all that was recorded it is known what was on the screen.
void expect_was_seen(const std::vector<simulator::DisplayFact>& facts, std::size_t ticks) {
  const auto all = some_display_facts(60'000);
  ASSERT_GE(facts.size() * 100, ticks);
  EXPECT_TRUE(std::equal(facts.begin(), facts.end(), all.begin()));
}

TEST(Kill, LosesAtMostTheCurrentHalfSecondAndNoOlderAttempt) {
  const TemporaryDirectory temporary{Medium::Disk};
  const simulator::Recording older = some_recording(3000);
  AttemptId older_id;
  {
    Database database = Database::open(temporary.data());
    older_id = record(database, some_attempt(database), older);
  }
  const simulator::Recording whole = some_recording(60'000);
  for (const std::int32_t ticks : {30, 640, 1190, 1730}) {
    const std::int32_t pushed = kill_after(temporary.data(), ticks);
    Database database = Database::open(temporary.data());
    EXPECT_TRUE(is_same(load_recording(database, older_id), older));
    const AttemptHeader killed = list_attempts(database).front();
    EXPECT_EQ(killed.state, AttemptState::Interrupted);
    const simulator::Recording rest = load_recording(database, killed.id);
    EXPECT_EQ(rest.samples.size(), rest.tape.size());
    EXPECT_TRUE(std::equal(rest.samples.begin(), rest.samples.end(), whole.samples.begin()));
    expect_was_seen(load_display_facts(database, killed.id), rest.samples.size());
    // Half a second being filled, two passes of the recorder and a commit on a loaded machine.
    EXPECT_LE(pushed - static_cast<std::int32_t>(rest.samples.size()), 500 + 400);
    const Verification found = verify(database);
    EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  }
  EXPECT_TRUE(std::filesystem::is_empty(temporary.data() / "writers"));
}

TEST(Kill, OfAnotherProcessIsNotAssumedWhileItLives) {
  const TemporaryDirectory temporary;
  { Database::open(temporary.data()); }
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) record_until_killed(temporary.data(), ends[1]);
  std::int32_t pushed = 0;
  ASSERT_EQ(::read(ends[0], &pushed, sizeof pushed), static_cast<ssize_t>(sizeof pushed));
  {
    Database database = Database::open(temporary.data());
    EXPECT_EQ(list_attempts(database).front().state, AttemptState::Recording);
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  Database database = Database::open(temporary.data());
  EXPECT_EQ(list_attempts(database).front().state, AttemptState::Interrupted);
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace

}  // namespace hallux::database
