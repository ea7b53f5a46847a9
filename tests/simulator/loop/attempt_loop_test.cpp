#include "simulator/loop/attempt_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>
#include <thread>

#include "tests/simulator/loop/recorded_run.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 1100;

/// The sawing motion in virtual time.
struct VirtualAttempt {
  Bone bone = tests::loop_block();
  HandMotion motion = tests::sawing_motion(bone, last_tick);
  AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
  ScriptedDevice device{motion};
};

TEST(VirtualLoop, PushesEveryLineAndEverySample) {
  VirtualAttempt attempt;
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device);
  EXPECT_EQ(run.statistics.end, AttemptEnd::Finished);
  EXPECT_EQ(run.statistics.lines, last_tick + 1);
  EXPECT_EQ(run.statistics.ticks, last_tick + 1);
  EXPECT_EQ(run.statistics.missed_ticks, 0);
  EXPECT_EQ(run.statistics.pauses, 0);
  ASSERT_EQ(run.recording.tape.size(), static_cast<std::size_t>(last_tick + 1));
  ASSERT_EQ(run.recording.samples.size(), run.recording.tape.size());
  for (std::size_t i = 0; i < run.recording.tape.size(); ++i) {
    EXPECT_EQ(run.recording.tape[i].tick, static_cast<std::int64_t>(i));
    EXPECT_EQ(run.recording.tape[i].ticks, 1);
    EXPECT_EQ(run.recording.samples[i].tick, static_cast<std::int64_t>(i));
  }
}

/// Starts, sees a hundred steps, and finishes.
class CountingOperator final : public AttemptOperator {
 public:
  void observe(const StepOutput& output) noexcept override { seen_tick = output.sample.tick; }
  bool take_command(Command& command) noexcept override {
    const bool is_first = said == 0, is_last = said == 1 && seen_tick == 99;
    if (!is_first && !is_last) return false;
    command = {is_first ? CommandKind::Start : CommandKind::Finish, 0, 0};
    ++said;
    return true;
  }
  double fraction_done() const noexcept override { return 0.25; }

  std::int64_t seen_tick = -1;
  int said = 0;
};

TEST(VirtualLoop, AnOperatorSeesEachStepAndItsCommandsStandOnTheNextLine) {
  VirtualAttempt attempt;
  CountingOperator counting;
  attempt.setup.commands.clear();
  attempt.setup.attempt_operator = &counting;
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device);
  EXPECT_EQ(run.statistics.end, AttemptEnd::Finished);
  ASSERT_EQ(run.recording.tape.size(), 101U);
  EXPECT_EQ(run.recording.tape.front().commands[0].kind, CommandKind::Start);
  EXPECT_EQ(run.recording.tape.back().command_count, 1U);
  EXPECT_EQ(run.recording.tape.back().commands[0].kind, CommandKind::Finish);
  EXPECT_EQ(counting.seen_tick, 100);
}

TEST(VirtualLoop, TellsHowFarItsOperatorIs) {
  VirtualAttempt attempt;
  CountingOperator counting;
  counting.said = 2;
  attempt.setup.attempt_operator = &counting;
  double told = 0.0;
  tests::record(attempt.setup, attempt.device, 4096, [&](double fraction) {
    told = fraction;
    return true;
  });
  EXPECT_EQ(told, 0.25);
}

TEST(VirtualLoop, EventsComeInTheOrderOfTheirTicks) {
  VirtualAttempt attempt;
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device);
  const auto& events = run.recording.events;
  ASSERT_GE(events.size(), 6U);
  EXPECT_EQ(events.front().kind, CutEventKind::Started);
  EXPECT_EQ(events.back().kind, CutEventKind::Finished);
  EXPECT_TRUE(std::is_sorted(events.begin(), events.end(),
                             [](const CutEvent& a, const CutEvent& b) { return a.tick < b.tick; }));
}

TEST(VirtualLoop, NothingIsLostThroughRingsMuchSmallerThanTheAttempt) {
  VirtualAttempt small, large;
  const tests::RecordedRun narrow = tests::record(small.setup, small.device, 16);
  const tests::RecordedRun wide = tests::record(large.setup, large.device, 65536);
  EXPECT_EQ(narrow.recording.tape, wide.recording.tape);
  EXPECT_EQ(narrow.recording.samples, wide.recording.samples);
  EXPECT_EQ(narrow.recording.events, wide.recording.events);
}

TEST(VirtualLoop, AJobIsAppliedAtTheTickAfterItsRequest) {
  VirtualAttempt attempt;
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device);
  int applied = 0;
  for (const TapeLine& line : run.recording.tape) {
    for (std::size_t i = 0; i < line.command_count; ++i) {
      if (line.commands[i].kind != CommandKind::ApplyJob) continue;
      EXPECT_EQ(line.commands[i].argument, applied);
      EXPECT_EQ(line.commands[i].detail, line.tick - 1);
      ++applied;
    }
  }
  EXPECT_EQ(applied,
            3);  // the contact; the pieces, at the break-through and when the blade has left
}

TEST(VirtualLoop, StopsAfterTheLastTickWithoutAFinish) {
  VirtualAttempt attempt;
  attempt.setup.commands.pop_back();
  attempt.setup.last_tick = 99;
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device);
  EXPECT_EQ(run.statistics.end, AttemptEnd::ReachedLastTick);
  EXPECT_EQ(run.recording.samples.size(), 100U);
}

TEST(VirtualLoop, CommandsBeyondTheRoomOfALineComeInTheNext) {
  VirtualAttempt attempt;
  attempt.setup.last_tick = 20;
  attempt.setup.commands.resize(1);
  for (std::int32_t step = 0; step < 6; ++step) {
    attempt.setup.commands.push_back({10, {CommandKind::StepDone, step, 0}});
  }
  const tests::RecordedRun run = tests::record(attempt.setup, attempt.device);
  EXPECT_EQ(run.recording.tape[10].command_count, 4);
  EXPECT_EQ(run.recording.tape[11].command_count, 2);
  std::int32_t next_step = 0;
  for (const CutEvent& event : run.recording.events) {
    if (event.kind != CutEventKind::StepDone) continue;
    EXPECT_EQ(event.subject, next_step++);
  }
  EXPECT_EQ(next_step, 6);
}

TEST(VirtualLoop, ProgressRisesFromZeroTowardsOne) {
  VirtualAttempt attempt;
  std::vector<double> fractions;
  tests::record(attempt.setup, attempt.device, 4096, [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  });
  ASSERT_GE(fractions.size(), 2U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GT(fractions.front(), 0.0);
  EXPECT_LE(fractions.back(), 1.0);
}

TEST(VirtualLoop, ProgressThatSaysNoCancelsTheAttempt) {
  VirtualAttempt attempt;
  const tests::RecordedRun run =
      tests::record(attempt.setup, attempt.device, 4096, [](double) { return false; });
  EXPECT_EQ(run.statistics.end, AttemptEnd::Cancelled);
  EXPECT_LT(run.statistics.lines, last_tick);
  EXPECT_EQ(run.recording.samples.size(), static_cast<std::size_t>(run.statistics.lines));
}

TEST(VirtualLoop, ARecorderThatFailedStopsTheAttemptAndTheChannelsAreClosed) {
  VirtualAttempt attempt;
  AttemptChannels channels(4096);
  channels.recorder_failed.store(true);
  const LoopStatistics statistics = run_attempt(attempt.setup, attempt.device, channels);
  EXPECT_EQ(statistics.end, AttemptEnd::RecorderFailed);
  EXPECT_EQ(statistics.lines, 0);
  EXPECT_TRUE(channels.closed.load());
}

TEST(VirtualLoop, ARecorderThatFailsWhileTheRingsAreFullDoesNotHoldTheLoop) {
  VirtualAttempt attempt;
  AttemptChannels channels(64);
  std::jthread recorder([&] {
    while (channels.samples.size() < 64) std::this_thread::yield();
    channels.recorder_failed.store(true);
  });
  const LoopStatistics statistics = run_attempt(attempt.setup, attempt.device, channels);
  EXPECT_EQ(statistics.end, AttemptEnd::RecorderFailed);
  EXPECT_LT(statistics.lines, last_tick);
  EXPECT_TRUE(channels.closed.load());
}

/// What a caller relies on however an attempt ends.
void expect_closed(const AttemptChannels& channels, AttemptWatch& watch) {
  EXPECT_TRUE(channels.closed.load());
  EXPECT_TRUE(watch.closed.load());
  EXPECT_TRUE(watch.view.read().is_over);
}

TEST(VirtualLoop, AProgressThatThrowsClosesChannelsAndWatchAndIsHeard) {
  VirtualAttempt attempt;
  AttemptWatch watch;
  attempt.setup.watch = &watch;
  AttemptChannels channels(4096);
  const auto run = [&] {
    run_attempt(attempt.setup, attempt.device, channels,
                [](double) -> bool { throw std::runtime_error("the window is gone"); });
  };
  EXPECT_THROW(run(), std::runtime_error);
  expect_closed(channels, watch);
}

/// Jobs on a worker that fell behind: its feed has no room from a line on.
class StuckJobs : public JobRunner {
 public:
  explicit StuckJobs(std::int64_t stuck_line) : stuck_line_(stuck_line) {}

  bool apply(const StepOutput&) override { return ++lines_ <= stuck_line_; }
  bool has_room() const noexcept override {
    if (lines_ < stuck_line_) return true;
    ++asked_;
    return false;
  }
  JobResult* take_ready() noexcept override { return nullptr; }

 protected:
  std::int64_t stuck_line_, lines_ = 0;
  mutable std::int64_t asked_ = 0;  ///< for room that there was not
};

/// They throw while the loop waits for room.
class FailingJobs final : public StuckJobs {
 public:
  using StuckJobs::StuckJobs;
  std::exception_ptr failure() const noexcept override {
    return asked_ < 20 ? nullptr : std::make_exception_ptr(std::bad_alloc());
  }
};

/// They throw at once, on the loop's own thread.
class ThrowingJobs final : public JobRunner {
 public:
  bool apply(const StepOutput& output) override {
    if (output.sample.tick == 100) throw std::bad_alloc();
    return true;
  }
  bool has_room() const noexcept override { return true; }
  JobResult* take_ready() noexcept override { return nullptr; }
};

TEST(VirtualLoop, AJobThatThrowsClosesChannelsAndWatchAndIsHeard) {
  VirtualAttempt attempt;
  AttemptWatch watch;
  ThrowingJobs jobs;
  attempt.setup.watch = &watch;
  attempt.setup.job_runner = &jobs;
  AttemptChannels channels(4096);
  EXPECT_THROW(run_attempt(attempt.setup, attempt.device, channels), std::bad_alloc);
  expect_closed(channels, watch);
}

TEST(RealTimeLoop, AWorkerThatFailsWhileItsFeedIsFullEndsThePause) {
  VirtualAttempt attempt;
  AttemptWatch watch;
  FailingJobs jobs(30);
  attempt.setup.watch = &watch;
  attempt.setup.job_runner = &jobs;
  attempt.setup.pacing = Pacing::RealTime;
  AttemptChannels channels(4096);
  EXPECT_THROW(run_attempt(attempt.setup, attempt.device, channels), std::bad_alloc);
  expect_closed(channels, watch);
  EXPECT_EQ(watch.view.read().lines, 30) << "nothing is stepped that has no room";
}

TEST(RealTimeLoop, APauseForAFullFeedCanBeCancelled) {
  VirtualAttempt attempt;
  StuckJobs jobs(30);
  attempt.setup.job_runner = &jobs;
  attempt.setup.pacing = Pacing::RealTime;
  AttemptChannels channels(4096);
  int asked = 0;
  const LoopStatistics statistics =
      run_attempt(attempt.setup, attempt.device, channels, [&](double) { return ++asked < 3; });
  EXPECT_EQ(statistics.end, AttemptEnd::Cancelled);
  EXPECT_EQ(asked, 3) << "it is asked again and again while it waits";
  EXPECT_EQ(statistics.lines, 30);
  EXPECT_GE(statistics.pauses, 1);
  EXPECT_TRUE(channels.closed.load());
}

TEST(VirtualLoop, MeasuresItsSteps) {
  VirtualAttempt attempt;
  const LoopStatistics statistics = tests::record(attempt.setup, attempt.device).statistics;
  EXPECT_GT(statistics.step_p50_us, 0.0);
  EXPECT_LE(statistics.step_p50_us, statistics.step_p99_us);
  EXPECT_LE(statistics.step_p99_us, statistics.step_max_us);
}

}  // namespace
}  // namespace hallux::simulator
