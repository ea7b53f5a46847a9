/// An attempt that somebody watches and commands while it runs.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "simulator/loop/replay.h"
#include "tests/simulator/loop/recorded_run.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 1100;

/// The sawing motion, without commands of its own.
struct WatchedAttempt {
  Bone bone = tests::loop_block();
  HandMotion motion = tests::sawing_motion(bone, last_tick);
  AttemptWatch watch;
  AttemptSetup setup{.simulation = {bone}, .last_tick = last_tick, .watch = &watch};
  ScriptedDevice device{motion};
};

Recording take_feed(AttemptWatch& watch) {
  Recording taken;
  GeometryFeed feed;
  while (watch.feed.pop(feed)) {
    if (const auto* sample = std::get_if<ToolSample>(&feed)) taken.samples.push_back(*sample);
    if (const auto* event = std::get_if<CutEvent>(&feed)) taken.events.push_back(*event);
  }
  return taken;
}

TEST(WatchedLoop, TakesCommandsInOrderAndTheyStandOnTheTape) {
  WatchedAttempt attempt;
  for (const CommandKind kind : {CommandKind::Start, CommandKind::Pause, CommandKind::Resume,
                                 CommandKind::StepDone, CommandKind::Finish}) {
    ASSERT_TRUE(attempt.watch.commands.push({kind, 0, 0}));
  }
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device);
  EXPECT_EQ(run.statistics.end, AttemptEnd::Finished);
  ASSERT_EQ(run.recording.tape.size(), 2U) << "four commands a line";
  EXPECT_EQ(run.recording.tape[0].commands[1].kind, CommandKind::Pause);
  EXPECT_EQ(run.recording.tape[1].commands[0].kind, CommandKind::Finish);
  const ReplayResult again = replay(run.recording, {attempt.bone, {}, {}, {}});
  EXPECT_TRUE(again.is_identical) << again.difference;
}

TEST(WatchedLoop, FeedsWhatItRecordsAndShowsWhereItEnded) {
  WatchedAttempt attempt;
  ASSERT_TRUE(attempt.watch.commands.push({CommandKind::Start, 0, 0}));
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device);
  const Recording fed = take_feed(attempt.watch);
  EXPECT_EQ(fed.samples, run.recording.samples);
  EXPECT_EQ(fed.events, run.recording.events);
  const LoopView& view = attempt.watch.view.read();
  EXPECT_TRUE(view.is_over);
  EXPECT_EQ(view.lines, run.statistics.lines);
  EXPECT_EQ(view.sample, run.recording.samples.back());
  EXPECT_TRUE(attempt.watch.closed.load());
}

TEST(WatchedLoop, AFeedThatNobodyEmptiesPausesInRealTimeAndNothingIsLost) {
  WatchedAttempt attempt;
  AttemptWatch small(64);
  attempt.setup.watch = &small;
  attempt.setup.pacing = Pacing::RealTime;
  attempt.setup.last_tick = 400;
  ASSERT_TRUE(small.commands.push({CommandKind::Start, 0, 0}));
  std::jthread reader([&](const std::stop_token& stop) {
    GeometryFeed feed;
    while (small.feed.size() <= 56) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    while (!stop.stop_requested()) {
      while (small.feed.pop(feed)) continue;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device, 65536);
  EXPECT_GE(run.statistics.pauses, 1);
  EXPECT_EQ(run.recording.samples.size(), run.recording.tape.size());
  const ReplayResult again = replay(run.recording, {attempt.bone, {}, {}, {}});
  EXPECT_TRUE(again.is_identical) << again.difference;
}

TEST(WatchedLoop, AFullDiskPausesForAsLongAndIsShown) {
  WatchedAttempt attempt;
  attempt.setup.pacing = Pacing::RealTime;
  attempt.setup.last_tick = 300;
  ASSERT_TRUE(attempt.watch.commands.push({CommandKind::Start, 0, 0}));
  AttemptChannels channels;
  const std::jthread disk([&] {
    const auto look = [&](bool is_full) {
      while (attempt.watch.view.read().is_storage_full != is_full) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    };
    while (attempt.watch.view.read().lines < 100) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    channels.storage_full.store(true);
    look(true);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    channels.storage_full.store(false);
    look(false);
  });
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device, channels);
  EXPECT_GE(run.statistics.pauses, 1);
  EXPECT_LT(run.statistics.unsampled_us, 500'000)
      << "the tool is safe while the disk is waited for";
  const ReplayResult again = replay(run.recording, {attempt.bone, {}, {}, {}});
  EXPECT_TRUE(again.is_identical) << again.difference;
}

}  // namespace
}  // namespace hallux::simulator
