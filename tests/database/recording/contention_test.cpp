/// Several processes in one directory: nobody is told that it is locked, and nothing is lost when
/// some of them are killed.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <thread>

#include "database/maintenance/verify.h"
#include "simulator/base/random.h"
#include "tests/database/killed_child.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

#ifdef HALLUX_LONG_RUNS
constexpr std::int32_t writes_each = 2000;
constexpr Medium medium = Medium::Disk;
#else
constexpr std::int32_t writes_each = 250;
constexpr Medium medium = Medium::Memory;
#endif
constexpr std::size_t writers = 8;
constexpr int kills_each = 5;

struct Written {
  std::int32_t acknowledged = 0;
  std::vector<std::int32_t> waited_us;
  int kills = 0;
};

/// Hears a child to its end, and kills it once it has acknowledged `kill_at`; false where it was
/// killed.
bool let_write(KilledChild& child, std::int32_t kill_at, Written& written) {
  bool is_killed = false;
  while (const auto word = child.listen()) {
    switch (word->kind) {
      case ChildWord::Kind::Began:
        // A write whose word was still to come when its writer was killed is there as well.
        EXPECT_GE(word->value, written.acknowledged) << "an acknowledged write is lost";
        EXPECT_LE(word->value, written.acknowledged + 1) << "a write was never told of";
        written.acknowledged = word->value;
        break;
      case ChildWord::Kind::Acknowledged:
        written.acknowledged = word->value;
        if (!is_killed && word->value >= kill_at) {
          child.kill();
          is_killed = true;
        }
        break;
      case ChildWord::Kind::Waited:
        written.waited_us.push_back(word->value);
        break;
      case ChildWord::Kind::Pushed:
        break;
      case ChildWord::Kind::Failed:
        ADD_FAILURE() << "a write failed; the reason stands above";
        return true;
    }
  }
  return !is_killed;
}

Written write_and_be_killed(const std::filesystem::path& directory, std::size_t writer) {
  Written written;
  Random random{writer + 1};
  for (bool is_done = false; !is_done;) {
    const std::int32_t next =
        written.acknowledged + 1 +
        static_cast<std::int32_t>(random.uniform(0.0, 2.0 * writes_each / (kills_each + 1)));
    const bool is_to_be_killed = written.kills < kills_each && next < writes_each;
    const std::int32_t kill_at = is_to_be_killed ? next : writes_each + 1;
    KilledChild child{{"write", directory.string(), "writer-" + std::to_string(writer),
                       std::to_string(writes_each)}};
    is_done = let_write(child, kill_at, written);
    if (!is_done) ++written.kills;
  }
  return written;
}

TEST(Contention, OfEightWritersWithRandomKillsLosesNothingAndLocksNobodyOut) {
  const TemporaryDirectory temporary{medium};
  { Database::open(temporary.data()); }
  std::array<Written, writers> written;
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < writers; ++i) {
      threads.emplace_back([&, i] { written[i] = write_and_be_killed(temporary.data(), i); });
    }
  }
  std::vector<std::int32_t> waited_us;
  int kills = 0;
  for (const Written& one : written) {
    EXPECT_EQ(one.acknowledged, writes_each);
    waited_us.insert(waited_us.end(), one.waited_us.begin(), one.waited_us.end());
    kills += one.kills;
  }
  std::sort(waited_us.begin(), waited_us.end());
  std::cout << waited_us.size() << " writes heard of, " << kills << " kills; a write took p50 "
            << waited_us[waited_us.size() / 2] << ", p99 " << waited_us[waited_us.size() * 99 / 100]
            << ", at most " << waited_us.back() << " us\n";
  EXPECT_GE(kills, static_cast<int>(writers));
  Database database = Database::open(temporary.data());
  SQLite::Statement rows{database.connection(),
                         "SELECT (SELECT count(*) FROM setting WHERE name GLOB 'writer-*'), "
                         "(SELECT count(*) FROM audit WHERE action = 'setting_changed')"};
  rows.executeStep();
  EXPECT_EQ(rows.getColumn(0).getInt(), static_cast<int>(writers) * writes_each);
  EXPECT_EQ(rows.getColumn(1).getInt(), static_cast<int>(writers) * writes_each);
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
}

TEST(Contention, TheFirstOpeningBySeveralProcessesAtOnceWorks) {
  for (int round = 0; round < 8; ++round) {
    const TemporaryDirectory temporary{medium};
    std::vector<std::unique_ptr<KilledChild>> children(6);
    for (std::unique_ptr<KilledChild>& child : children) {
      child = std::make_unique<KilledChild>(
          std::vector<std::string>{"open", temporary.data().string()});
    }
    for (const auto& child : children) EXPECT_EQ(child->wait(), 0);
    Database database = Database::open(temporary.data());
    EXPECT_TRUE(verify(database).is_whole());
  }
}

}  // namespace

}  // namespace hallux::database
