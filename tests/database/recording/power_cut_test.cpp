/// Unsynced writes that are lost, torn or kept at random when the power goes: nothing acknowledged
/// is missing afterwards.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <iostream>

#include "database/course/begin_attempt.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "database/recording/window_writer.h"
#include "database/store/sql.h"
#include "simulator/base/random.h"
#include "tests/database/some_database.h"
#include "tests/support/power_cut_vfs.h"

namespace hallux::database {

namespace {

constexpr std::int64_t windows_recorded = 40;

/// What one disk held after a power cut, and what had been acknowledged when it came.
struct CutDisk {
  std::unique_ptr<TemporaryDirectory> place = std::make_unique<TemporaryDirectory>();
  std::int64_t acknowledged_windows = 0;
};

OpenOptions through(const tests::PowerCutVfs& vfs) {
  OpenOptions options;
  options.vfs_name = vfs.name();
  return options;
}

WindowRows rows_of(const simulator::Recording& recording, std::int64_t window) {
  WindowRows rows;
  const auto take = [window](const auto& from, auto& into) {
    for (const auto& row : from) {
      if (row.tick / window_ticks == window) into.push_back(row);
    }
  };
  take(recording.tape, rows.tape);
  take(recording.samples, rows.samples);
  take(recording.events, rows.events);
  return rows;
}

/// Records through the file system; before about one write in `rarity` its disk is copied as a cut
/// would leave it.
std::vector<CutDisk> cut_while_recording(const simulator::Recording& recording, double rarity) {
  const TemporaryDirectory temporary;
  tests::PowerCutVfs vfs{"power_cut"};
  std::vector<CutDisk> disks;
  std::int64_t acknowledged = 0;
  Random random{2024};
  {
    Database database = Database::open(temporary.data(), through(vfs));
    const NewAttempt attempt = some_attempt(database);
    const WriterLease lease = create_attempt(database, attempt);
    vfs.before_write = [&] {
      if (random.uniform() * rarity >= 1.0) return;
      CutDisk disk;
      std::filesystem::create_directory(disk.place->data());
      vfs.leave_after_power_cut(disk.place->data(), random.bits());
      disk.acknowledged_windows = acknowledged;
      disks.push_back(std::move(disk));
    };
    WindowWriter pen{database.open_again(), lease.attempt()};
    for (std::int64_t window = 0; window < windows_recorded; ++window) {
      pen.commit(window, rows_of(recording, window));
      acknowledged = window + 1;
      // The log begins anew now and then, which is when both files change.
      if (window % 7 == 6) {
        pen.database().connection().exec("PRAGMA wal_checkpoint(RESTART)");
      }
    }
    vfs.before_write = nullptr;
  }
  return disks;
}

TEST(PowerCut, LosesNothingAcknowledgedWhicheverUnsyncedWritesAreLost) {
  const simulator::Recording recording = some_recording(windows_recorded * window_ticks);
  const std::vector<CutDisk> disks = cut_while_recording(recording, 3.0);
  ASSERT_GE(disks.size(), 100U);
  std::int64_t unacknowledged_kept = 0;
  for (const CutDisk& disk : disks) {
    Database database = Database::open(disk.place->data());
    const AttemptHeader header = list_attempts(database).front();
    EXPECT_EQ(header.state, AttemptState::Interrupted);
    const simulator::Recording rest = load_recording(database, header.id);
    const auto windows = static_cast<std::int64_t>(rest.samples.size()) / window_ticks;
    EXPECT_GE(windows, disk.acknowledged_windows);
    EXPECT_LE(windows, disk.acknowledged_windows + 1);
    unacknowledged_kept += windows - disk.acknowledged_windows;
    EXPECT_TRUE(std::equal(rest.samples.begin(), rest.samples.end(), recording.samples.begin()));
    EXPECT_TRUE(std::equal(rest.tape.begin(), rest.tape.end(), recording.tape.begin()));
    const Verification found = verify(database);
    EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  }
  std::cout << disks.size() << " power cuts, " << unacknowledged_kept
            << " of them left a window that was not acknowledged yet\n";
}

/// So that the test above cannot pass by a file system that loses nothing.
TEST(PowerCut, TakesWhatWasNeverSynced) {
  const TemporaryDirectory temporary;
  tests::PowerCutVfs vfs{"never_synced"};
  Database database = Database::open(temporary.data(), through(vfs));
  database.connection().exec("PRAGMA synchronous = OFF");
  int lost = 0;
  for (int i = 0; i < 40; ++i) {
    const std::string name = "number " + std::to_string(i);
    in_transaction(database, "write",
                   [&] { execute(database, "INSERT INTO setting VALUES (?, '', '')", name); });
    const TemporaryDirectory after;
    std::filesystem::create_directory(after.data());
    vfs.leave_after_power_cut(after.data(), static_cast<std::uint64_t>(i));
    try {
      Database left = Database::open(after.data());
      SQLite::Statement row{left.connection(), "SELECT 1 FROM setting WHERE name = ?"};
      row.bind(1, name);
      lost += row.executeStep() ? 0 : 1;
    } catch (const std::exception&) {
      ++lost;
    }
  }
  EXPECT_GE(lost, 5);
}

}  // namespace

}  // namespace hallux::database
