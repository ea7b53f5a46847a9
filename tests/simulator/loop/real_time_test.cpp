/// The loop against the clock, with jobs that come late: what is recorded is enough, whatever the
/// timing was.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "simulator/base/random.h"
#include "simulator/device/force_output.h"
#include "simulator/device/modelled/modelled_arm.h"
#include "simulator/loop/locked_memory.h"
#include "simulator/loop/replay.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/loop/watched_device.h"

namespace hallux::simulator {
namespace {

/// Each result waits a random time beyond its own before it is ready.
class LateJobs final : public JobRunner {
 public:
  LateJobs(const Bone& bone, std::uint64_t seed, double delay_max_ms)
      : whole_(solid_of(bone)),
        jobs_({whole_, bone.world_from_bone}, Blade{}),
        random_(seed),
        delay_max_ms_(delay_max_ms) {}

  bool apply(const StepOutput& output) override { return jobs_.apply(output); }
  bool has_room() const noexcept override { return jobs_.has_room(); }
  /// Asked once a tick while nothing is ready.
  JobResult* take_ready() noexcept override {
    if (late_ == nullptr) {
      late_ = jobs_.take_ready();
      left_ms_ = random_.uniform(0.0, delay_max_ms_);
    }
    if (late_ == nullptr || --left_ms_ > 0.0) return nullptr;
    return std::exchange(late_, nullptr);
  }

 private:
  const WholeBone whole_;
  ThreadedJobs jobs_;
  Random random_;
  double delay_max_ms_, left_ms_ = 0.0;
  JobResult* late_ = nullptr;
};

tests::RecordedRun record_in_real_time(const Bone& bone, std::int64_t last_tick,
                                       JobRunner* jobs = nullptr) {
  const HandMotion motion = tests::sawing_motion(bone, last_tick);
  AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
  setup.pacing = Pacing::RealTime;
  setup.job_runner = jobs;
  ScriptedDevice device(motion);
  return tests::record(setup, device, 65536);
}

std::int64_t ticks_on(const std::vector<TapeLine>& tape) {
  std::int64_t ticks = 0;
  for (const TapeLine& line : tape) ticks += line.ticks;
  return ticks;
}

/// Records `count` runs with late jobs; each must replay to its own outputs. Returns how many tapes
/// differ.
std::size_t count_tapes_that_replay(std::uint64_t count, std::int64_t last_tick) {
  const Bone bone = tests::loop_block();
  std::set<std::string> tapes;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    LateJobs jobs(bone, seed, 500.0);
    const tests::RecordedRun run = record_in_real_time(bone, last_tick, &jobs);
    EXPECT_EQ(run.statistics.end, AttemptEnd::Finished);
    EXPECT_EQ(ticks_on(run.recording.tape), run.statistics.ticks);
    const ReplayResult result = replay(run.recording, {bone, {}, {}, {}});
    EXPECT_TRUE(result.is_identical) << "seed " << seed << ", tick " << result.first_difference_tick
                                     << ": " << result.difference;
    EXPECT_EQ(result.outputs, digest_outputs(run.recording)) << "seed " << seed;
    tapes.insert(hex_from_digest(tests::digest_of_tape(run.recording)));
  }
  return tapes.size();
}

#ifdef HALLUX_LONG_RUNS
TEST(RealTimeReplay, FiftyRunsWithLateJobsDifferAndEachReplaysToItsOwnHash) {
  // Two runs share a tape only if both of their jobs come at the same ticks and no tick was ever
  // late.
  EXPECT_EQ(count_tapes_that_replay(50, 5000), 50U);
}
#else
TEST(RealTimeReplay, RunsWithLateJobsDifferAndEachReplaysToItsOwnHash) {
  EXPECT_EQ(count_tapes_that_replay(3, 1800), 3U);
}

TEST(RealTimeLoop, KeepsTheClocksPaceWithoutLosingATick) {
  const Bone bone = tests::loop_block();
  const tests::RecordedRun run = record_in_real_time(bone, 1000);
  EXPECT_EQ(run.statistics.end, AttemptEnd::Finished);
  EXPECT_EQ(ticks_on(run.recording.tape), run.statistics.ticks);
  EXPECT_EQ(run.statistics.lines, static_cast<std::int64_t>(run.recording.tape.size()));
  EXPECT_EQ(run.recording.samples.size(), run.recording.tape.size());
  std::int64_t next_tick = 0, missed_ticks = 0;
  for (const TapeLine& line : run.recording.tape) {
    EXPECT_EQ(line.tick, next_tick);
    EXPECT_GE(line.ticks, 1);
    EXPECT_LE(line.ticks, 3);
    next_tick += line.ticks;
    missed_ticks += line.ticks - 1;
  }
  EXPECT_EQ(missed_ticks, run.statistics.missed_ticks);
}

/// Keeps the loop waiting at the ticks from `first` to `last`.
struct Stall {
  std::int64_t first_tick = 100, last_tick = 100;
  std::chrono::microseconds wait{50000};
};

/// A hand that keeps the loop waiting.
class StallingDevice final : public HapticDevice {
 public:
  StallingDevice(const HandMotion& motion, const Stall& stall) : hand_(motion), stall_(stall) {}
  DeviceDescription description() const override { return hand_.description(); }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override {
    const bool is_due = tick >= stall_.first_tick && !is_over_;
    is_over_ = tick >= stall_.last_tick;
    if (is_due) std::this_thread::sleep_for(stall_.wait);
    return hand_.exchange(force_in_world_newton, tick, state);
  }

 private:
  ScriptedDevice hand_;
  Stall stall_;
  bool is_over_ = false;
};

/// Up to 300 ticks of sawing with that hand and these commands.
tests::RecordedRun record_with_a_stall(const Bone& bone, std::vector<HandCommand> commands,
                                       const Stall& stall = {}, std::int64_t last_tick = 300) {
  const AttemptSetup setup{.simulation = {bone},
                           .pacing = Pacing::RealTime,
                           .commands = std::move(commands),
                           .last_tick = last_tick};
  StallingDevice device(tests::sawing_motion(bone, 300), stall);
  return tests::record(setup, device, 65536);
}

/// The events of pausing alone, in order.
std::vector<CutEventKind> pauses_of(const Recording& recording) {
  std::vector<CutEventKind> kinds;
  for (const CutEvent& event : recording.events) {
    const bool is_about_pausing =
        event.kind == CutEventKind::Paused || event.kind == CutEventKind::Resumed;
    if (is_about_pausing) kinds.push_back(event.kind);
  }
  return kinds;
}

TEST(RealTimeLoop, AGapIsAPauseAndAResumeOnTheTape) {
  const Bone bone = tests::loop_block();
  const tests::RecordedRun run = record_with_a_stall(bone, {{0, {CommandKind::Start, 0, 0}}});
  EXPECT_GE(run.statistics.pauses, 1);
  EXPECT_GE(run.statistics.unsampled_us, 3'000 * run.statistics.pauses)
      << "each beyond three ticks";
  EXPECT_EQ(run.statistics.clock_steps, 0);
  const auto kinds = pauses_of(run.recording);
  ASSERT_GE(kinds.size(), 2U);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    EXPECT_EQ(kinds[i], i % 2 == 0 ? CutEventKind::Paused : CutEventKind::Resumed) << i;
  }
  EXPECT_LE((static_cast<std::int64_t>(kinds.size()) + 1) / 2, run.statistics.pauses);
  EXPECT_TRUE(replay(run.recording, {bone, {}, {}, {}}).is_identical);
}

TEST(RealTimeLoop, ACommandAtTheLastTickIsHeardWhenItsLineCoversMoreTicks) {
  const Bone bone = tests::loop_block();
  for (std::int64_t last_tick = 100; last_tick < 106; ++last_tick) {
    // Each line is late by about a tick, so most cover two or three.
    const tests::RecordedRun run = record_with_a_stall(
        bone, {{0, {CommandKind::Start, 0, 0}}, {last_tick, {CommandKind::Finish, 0, 0}}},
        {.first_tick = 50, .last_tick = 200, .wait = std::chrono::microseconds{2300}}, last_tick);
    EXPECT_EQ(run.statistics.end, AttemptEnd::Finished) << last_tick;
  }
}

TEST(RealTimeLoop, AGapDoesNotResumeWhatTheOperatorPaused) {
  const Bone bone = tests::loop_block();
  const tests::RecordedRun run = record_with_a_stall(
      bone, {{0, {CommandKind::Start, 0, 0}}, {50, {CommandKind::Pause, 0, 0}}});
  EXPECT_GE(run.statistics.pauses, 1);
  EXPECT_FALSE(has(run.recording.samples.back().status, ToolStatus::Running));
}

TEST(RealTimeLoop, AfterAGapAnArmIsGivenNothingAtOnceAndThenBeginsSoftly) {
  const Bone bone = tests::loop_block();
  const HandMotion motion = tests::sawing_motion(bone, 1500);
  ModelledArm arm(motion, {});
  tests::WatchedDevice device(arm);
  std::size_t stalled_at = 0;  // the exchange after which the loop waited
  device.after_exchange = [&](std::int64_t tick) {
    if (stalled_at > 0 || tick < 650) return;  // in the midst of the bone
    stalled_at = device.given_newton.size() - 1;
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
  };
  AttemptSetup setup = tests::setup_for(bone, motion, 1500);
  setup.pacing = Pacing::RealTime;
  const tests::RecordedRun run = tests::record(setup, device, 65536);
  ASSERT_GT(stalled_at, 0U);
  EXPECT_GE(run.statistics.pauses, 1);
  const Vec3 nothing(0.0, 0.0, 0.0);
  EXPECT_EQ(device.given_newton.at(stalled_at + 1), nothing);
  EXPECT_EQ(device.given_newton.back(), nothing) << "and nothing after the end";
  EXPECT_TRUE(has(run.statistics.force_limits, ForceLimit::SoftStart));
  const auto is_something = [&](const Vec3& force) { return force != nothing; };
  EXPECT_TRUE(std::any_of(device.given_newton.begin(), device.given_newton.end(), is_something));
  EXPECT_TRUE(replay(run.recording, {bone, {}, {}, {}}).is_identical);
}

TEST(RealTimeLoop, IsLockedInMemoryWhereItIsWatchedAndTheSystemAllowsIt) {
  const bool is_allowed = LockedMemory().is_granted();
  const Bone bone = tests::loop_block();
  AttemptWatch watch;
  for (AttemptWatch* watching : {&watch, static_cast<AttemptWatch*>(nullptr)}) {
    ScriptedDevice device(tests::sawing_motion(bone, 50));
    const AttemptSetup setup{
        .simulation = {bone}, .pacing = Pacing::RealTime, .last_tick = 50, .watch = watching};
    const LoopStatistics statistics = tests::record(setup, device, 65536).statistics;
    EXPECT_EQ(statistics.has_locked_memory, is_allowed && watching != nullptr);
    EXPECT_EQ(statistics.force_scale, 1.0) << "a scripted hand is pushed by nobody";
  }
  EXPECT_EQ(watch.view.read().has_locked_memory, is_allowed);
}
#endif

}  // namespace
}  // namespace hallux::simulator
