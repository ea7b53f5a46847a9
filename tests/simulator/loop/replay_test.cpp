#include "simulator/loop/replay.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "simulator/base/random.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/step/simulation_run.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 750;
/// The blade is in its kerf and sawing.
constexpr std::size_t sawing_line = 300;

/// The sawing motion, recorded in virtual time.
struct RecordedCut {
  RecordedCut() {
    const HandMotion motion = tests::sawing_motion(bone, last_tick);
    const AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
    ScriptedDevice device(motion);
    recording = tests::record(setup, device).recording;
  }
  ReplayResult replayed(const ContactSettings& settings = {}, const Saw& saw = {}) const {
    return replay(recording, {bone, saw, settings});
  }
  /// The first line that applies a job.
  TapeLine& job_line() {
    return *std::find_if(recording.tape.begin(), recording.tape.end(), [](const TapeLine& line) {
      return line.command_count > 0 && line.commands[0].kind == CommandKind::ApplyJob;
    });
  }

  Bone bone = tests::loop_block();
  Recording recording;
};

void expect_difference(const ReplayResult& result, std::int64_t tick) {
  EXPECT_FALSE(result.is_identical);
  EXPECT_EQ(result.first_difference_tick, tick);
  EXPECT_FALSE(result.difference.empty());
}

TEST(Replay, OfARecordedCutIsIdentical) {
  const RecordedCut cut;
  const auto kinds = tests::kinds_of(cut.recording);
  ASSERT_NE(std::find(kinds.begin(), kinds.end(), CutEventKind::PieceFreed), kinds.end());
  const ReplayResult result = cut.replayed();
  EXPECT_TRUE(result.is_identical) << result.difference;
  EXPECT_EQ(result.first_difference_tick, -1);
  EXPECT_EQ(result.outputs, digest_outputs(cut.recording));
  EXPECT_EQ(result.samples, static_cast<std::int64_t>(cut.recording.samples.size()));
  EXPECT_NE(result.bone, digest_of_mesh(solid_of(cut.bone)));
}

TEST(Replay, OfAGuidedCutIsIdenticalWithItsGuideAndDiffersWithoutIt) {
  const Bone bone = tests::loop_block();
  const HandMotion motion = tests::sawing_motion(bone, last_tick);
  ContactSettings guided;
  // The hand saws at x = 5: led away from there.
  guided.guide = {Guidance::Slot, {GuidePlane{Vec3(1.0, 0.0, 0.0), 3.0}}};
  AttemptSetup setup = tests::setup_for(bone, motion, last_tick);
  setup.simulation.contact = guided;
  ScriptedDevice device(motion);
  const Recording recording = tests::record(setup, device).recording;
  const ReplayResult result = replay(recording, {bone, {}, guided, {}});
  EXPECT_TRUE(result.is_identical) << result.difference;
  EXPECT_FALSE(replay(recording, {bone, {}, {}, {}}).is_identical);
  guided.guide.guidance = Guidance::Soft;
  EXPECT_FALSE(replay(recording, {bone, {}, guided, {}}).is_identical);
}

TEST(Replay, OfAnEmptyRecordingIsIdentical) {
  const Bone bone = tests::loop_block();
  EXPECT_TRUE(replay({}, {bone, {}, {}, {}}).is_identical);
}

TEST(Replay, OneAlteredInputDiffersFromItsOwnTick) {
  RecordedCut cut;
  cut.recording.tape[sawing_line].device.world_from_handle.translation_um[1] += 50;
  expect_difference(cut.replayed(), cut.recording.tape[sawing_line].tick);
}

TEST(Replay, OneAlteredSwitchDiffersFromItsOwnTick) {
  RecordedCut cut;
  cut.recording.tape[sawing_line].device.switches = 0;
  expect_difference(cut.replayed(), cut.recording.tape[sawing_line].tick);
}

TEST(Replay, OneAlteredSampleDiffersAtItsTick) {
  RecordedCut cut;
  cut.recording.samples[sawing_line].force_mn[2] += 1;
  expect_difference(cut.replayed(), cut.recording.samples[sawing_line].tick);
}

TEST(Replay, OneAlteredEventDiffersAtItsTick) {
  RecordedCut cut;
  CutEvent& event = cut.recording.events[2];
  event.value += 1;
  expect_difference(cut.replayed(), event.tick);
}

TEST(Replay, AnInputThatIsNotFollowedIsADifference) {
  RecordedCut cut;
  cut.recording.tape.resize(sawing_line);
  expect_difference(cut.replayed(), static_cast<std::int64_t>(sawing_line));
}

TEST(Replay, OutputsThatAreMissingAreADifference) {
  RecordedCut cut;
  cut.recording.samples.resize(sawing_line);
  expect_difference(cut.replayed(), static_cast<std::int64_t>(sawing_line));
}

TEST(Replay, ALineThatIsMissingIsADifference) {
  RecordedCut cut;
  cut.recording.tape.erase(cut.recording.tape.begin() + sawing_line);
  expect_difference(cut.replayed(), static_cast<std::int64_t>(sawing_line));
}

TEST(Replay, ALineOfNoTicksOrTooManyIsADifference) {
  for (const int ticks : {0, 4, 9}) {
    RecordedCut cut;
    cut.recording.tape[sawing_line].ticks = static_cast<std::uint8_t>(ticks);
    expect_difference(cut.replayed(), static_cast<std::int64_t>(sawing_line));
  }
}

TEST(Replay, MoreCommandsThanALineHoldsAreADifference) {
  RecordedCut cut;
  cut.recording.tape[sawing_line].command_count = 200;
  expect_difference(cut.replayed(), static_cast<std::int64_t>(sawing_line));
}

TEST(Replay, AJobThatWasNotAskedForIsADifference) {
  for (const std::int32_t job : {-1, 1, 99}) {
    RecordedCut cut;
    TapeLine& line = cut.job_line();
    line.commands[0].argument = job;
    expect_difference(cut.replayed(), line.tick);
  }
}

TEST(Replay, AJobThatIsAppliedTwiceIsADifference) {
  RecordedCut cut;
  TapeLine& line = cut.job_line();
  line.commands[1] = line.commands[0];
  line.command_count = 2;
  expect_difference(cut.replayed(), line.tick);

  RecordedCut later;
  const TapeLine& applied = later.job_line();
  TapeLine& next = later.recording.tape[static_cast<std::size_t>(applied.tick) + 1];
  next.commands[0] = applied.commands[0];
  next.command_count = 1;
  expect_difference(later.replayed(), next.tick);
}

TEST(Replay, AJobOfAnotherTickIsADifference) {
  RecordedCut cut;
  TapeLine& line = cut.job_line();
  line.commands[0].detail -= 1;
  expect_difference(cut.replayed(), line.tick);
}

TEST(Replay, AJobAppliedATickLaterIsADifference) {
  RecordedCut cut;
  TapeLine& line = cut.job_line();
  TapeLine& next = cut.recording.tape[static_cast<std::size_t>(line.tick) + 1];
  ASSERT_EQ(next.command_count, 0);
  std::swap(line.commands, next.commands);
  std::swap(line.command_count, next.command_count);
  expect_difference(cut.replayed(), next.tick);
}

TEST(Replay, AChangedConstantOfTheStepDiffersFromTheFirstTouch) {
  const RecordedCut cut;
  const auto touch = std::find_if(cut.recording.samples.begin(), cut.recording.samples.end(),
                                  [](const ToolSample& sample) {
                                    return sample.force_mn != std::array<std::int32_t, 3>{0, 0, 0};
                                  });
  ASSERT_NE(touch, cut.recording.samples.end());
  expect_difference(cut.replayed({.coupling_newton_per_mm = 2.5}), touch->tick);
  const ReplayResult slower = cut.replayed({}, {.cycles_per_minute = 11000.0});
  EXPECT_FALSE(slower.is_identical);
  EXPECT_GE(slower.first_difference_tick, touch->tick);
}

TEST(Replay, CanBeCancelled) {
  const RecordedCut cut;
  const ReplayResult result =
      replay(cut.recording, {cut.bone, {}, {}, {}}, [](double) { return false; });
  EXPECT_FALSE(result.is_identical);
  EXPECT_NE(result.difference.find("cancelled"), std::string::npos);
}

TEST(Replay, NoNumberOnTheTapeMakesItCrash) {
  const RecordedCut cut;
  Random random{1};
  for (int i = 0; i < 8; ++i) {
    Recording altered = cut.recording;
    TapeLine& line = altered.tape[random.bits() % altered.tape.size()];
    auto columns = columns_of(line);
    columns[random.bits() % columns.size()] = static_cast<std::int64_t>(random.bits());
    line = tape_line_from(columns);
    const ReplayResult result = replay(altered, {cut.bone, {}, {}, {}});
    EXPECT_EQ(result.is_identical, result.first_difference_tick == -1) << "alteration " << i;
  }
}

}  // namespace
}  // namespace hallux::simulator
