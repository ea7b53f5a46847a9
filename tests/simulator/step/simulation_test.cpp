#include "simulator/step/simulation.h"

#include <gtest/gtest.h>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::kinds_of;
using tests::SimulationRun;

constexpr double top_mm = 4.0;
constexpr double above_mm = top_mm + 1.0;

Bone block() { return tests::cancellous_bone(tests::solid_block({30.0, 8.0, 6.0})); }

Command command(CommandKind kind, std::int32_t argument = 0) { return {kind, argument, 0}; }

bool has_status(const StepOutput& output, ToolStatus status) {
  return has(output.sample.status, status);
}

/// Half a second of sawing; the blade is then in its kerf.
void saw_into(SimulationRun& run) {
  run.glide(blade_down({0.0, above_mm, 0.0}), 10);
  run.glide(blade_down({0.0, top_mm - 8.0, 0.0}), 500);
}

TEST(Step, StartPutsTheToolInTheHandAndRunsTheClock) {
  const Bone bone = block();
  const SimulationRun run(bone, blade_down({3.0, above_mm, 0.5}));
  EXPECT_TRUE(run.simulation().is_running());
  EXPECT_EQ(run.events(CutEventKind::Started).size(), 1U);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.x, 3.0, 0.002);
  EXPECT_TRUE(has(run.recording().samples[0].status, ToolStatus::Running));
}

TEST(Step, NothingRunsBeforeTheStart) {
  const Bone bone = block();
  const TissueMap tissue{bone};
  Simulation simulation(tissue, {bone});
  TapeLine line;
  line.device.switches = tests::saw_runs;
  const StepOutput output = simulation.step({line, {}});
  EXPECT_FALSE(has_status(output, ToolStatus::Running));
  EXPECT_EQ(output.events.size(), 0U);
  EXPECT_EQ(output.sample.force_mn, (std::array<std::int32_t, 3>{0, 0, 0}));
}

TEST(Step, PauseHoldsTheToolAndItsForceUntilResume) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  saw_into(run);
  EXPECT_GT(run.force_in_bone_newton().y, 5.0);
  const QuantisedPose before = run.recording().samples.back().world_from_tool;
  StepOutput output = run.step({command(CommandKind::Pause)});
  EXPECT_FALSE(has_status(output, ToolStatus::Running));
  output = run.hold(50);
  EXPECT_EQ(output.sample.world_from_tool, before);
  EXPECT_EQ(output.sample.force_mn, (std::array<std::int32_t, 3>{0, 0, 0}));
  output = run.step({command(CommandKind::Resume)});
  EXPECT_TRUE(has_status(output, ToolStatus::Running));
  EXPECT_TRUE(has_status(output, ToolStatus::InKerf));
  EXPECT_EQ(run.events(CutEventKind::Paused).size(), 1U);
  EXPECT_EQ(run.events(CutEventKind::Resumed).size(), 1U);
}

TEST(Step, AStartInAFaultPutsTheToolInTheHandOnceTheFaultIsOver) {
  // What stands on the tape until then is nobody's place: the middle of the bone.
  Bone bone = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 6.0}));
  bone.world_from_bone = {};
  const TissueMap tissue(bone);
  Simulation simulation(tissue, {bone});
  const QuantisedPose hand = quantise(blade_down({0.0, above_mm + 3.0, 0.0}));
  TapeLine line;
  line.commands[0] = command(CommandKind::Start);
  line.command_count = 1;
  line.device = {{}, tests::saw_runs, static_cast<std::uint32_t>(DeviceFault::Lost)};
  for (int i = 0; i < 3; ++i) {
    const StepOutput output = simulation.step({line, {}});
    EXPECT_EQ(output.sample.force_mn, (std::array<std::int32_t, 3>{0, 0, 0}));
    line.command_count = 0;
    line.tick += line.ticks;
  }
  line.device = {hand, tests::saw_runs, 0};
  for (int i = 0; i < 100; ++i) {
    const StepOutput output = simulation.step({line, {}});
    EXPECT_EQ(output.sample.world_from_tool, hand) << i;
    for (const CutEvent& event : output.events) EXPECT_EQ(event.kind, CutEventKind::Fault);
    line.tick += line.ticks;
  }
  EXPECT_EQ(simulation.kerfs().count(), 0);
}

TEST(Step, AGapThatBeganBeforeTheStartIsNoPauseOfTheOperation) {
  const Bone bone = block();
  const TissueMap tissue(bone);
  Simulation simulation(tissue, {bone});
  TapeLine line;
  const auto kinds_after = [&](const Command& said) {
    line.commands[0] = said;
    line.command_count = 1;
    std::vector<CutEventKind> kinds;
    for (const CutEvent& event : simulation.step({line, {}}).events) kinds.push_back(event.kind);
    line.tick += line.ticks;
    return kinds;
  };
  EXPECT_TRUE(kinds_after(command(CommandKind::Pause, paused_by_loop)).empty());
  EXPECT_EQ(kinds_after(command(CommandKind::Start)), std::vector{CutEventKind::Started});
  EXPECT_TRUE(kinds_after(command(CommandKind::Resume, paused_by_loop)).empty());
  EXPECT_TRUE(simulation.is_running());
  EXPECT_EQ(kinds_after(command(CommandKind::Pause, paused_by_loop)),
            std::vector{CutEventKind::Paused});
  EXPECT_EQ(kinds_after(command(CommandKind::Resume, paused_by_loop)),
            std::vector{CutEventKind::Resumed});
}

TEST(Step, AStepDeclaredDoneIsAnEventThatNamesIt) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.step({command(CommandKind::StepDone, 2)});
  const auto done = run.events(CutEventKind::StepDone);
  ASSERT_EQ(done.size(), 1U);
  EXPECT_EQ(done[0].subject, 2);
  EXPECT_EQ(done[0].tick, 1);
}

TEST(Step, AStepTakenUpAgainIsAnEventThatNamesIt) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.step({command(CommandKind::StepDone, 1), command(CommandKind::ReopenStep, 1)});
  const auto reopened = run.events(CutEventKind::StepReopened);
  ASSERT_EQ(reopened.size(), 1U);
  EXPECT_EQ(reopened[0].subject, 1);
  EXPECT_EQ(reopened[0].tick, 1);
}

TEST(Step, APieceThatIsNotThereCannotBePickedUp) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  for (const std::int32_t piece : {-1, 0, 1, 1000000}) {
    run.step({command(CommandKind::PickUp, piece)});
  }
  EXPECT_TRUE(run.events(CutEventKind::PieceRemoved).empty());
}

TEST(Step, FinishEndsTheAttemptForGood) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.step({command(CommandKind::Finish)});
  EXPECT_TRUE(run.simulation().is_over());
  const StepOutput output = run.step({command(CommandKind::Start), command(CommandKind::Resume),
                                      command(CommandKind::StepDone, 1)});
  EXPECT_FALSE(has_status(output, ToolStatus::Running));
  EXPECT_EQ(output.events.size(), 0U);
  EXPECT_EQ(run.events(CutEventKind::Finished).size(), 1U);
}

TEST(Step, ATouchThatGoesOnAtTheEndIsAScratch) {
  const Bone bone = block();
  for (const CommandKind end : {CommandKind::Finish, CommandKind::Abandon}) {
    SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
    run.glide(blade_down({0.0, top_mm - 0.5, 0.0}), 100);
    run.hold(50);
    ASSERT_EQ(run.events(CutEventKind::Contact).size(), 1U);
    ASSERT_TRUE(run.events(CutEventKind::PlaneFrozen).empty());
    const double depth_mm = top_mm - run.bone_from_tool().translation_mm.y;
    run.step({command(end)});
    const auto scratches = run.events(CutEventKind::Scratch);
    ASSERT_EQ(scratches.size(), 1U);
    EXPECT_GT(scratches[0].value, 0);
    EXPECT_NEAR(static_cast<double>(scratches[0].value), 1000.0 * depth_mm, 25.0);
    EXPECT_NE(kinds_of(run.recording()).back(), CutEventKind::Scratch) << "told before the end";
  }
}

TEST(Step, AbandonEndsItToo) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.step({command(CommandKind::Abandon)});
  EXPECT_TRUE(run.simulation().is_over());
  EXPECT_EQ(run.events(CutEventKind::Abandoned).size(), 1U);
}

TEST(Step, CommandsOfOneLineActInTheirOrder) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.step({command(CommandKind::Pause), command(CommandKind::Resume),
            command(CommandKind::StepDone, 0), command(CommandKind::Finish)});
  EXPECT_EQ(kinds_of(run.recording()),
            (std::vector{CutEventKind::Started, CutEventKind::Paused, CutEventKind::Resumed,
                         CutEventKind::StepDone, CutEventKind::Finished}));
}

TEST(Step, AFaultFreezesTheToolAndTakesTheForceAway) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  saw_into(run);
  const QuantisedPose before = run.recording().samples.back().world_from_tool;
  run.faults = static_cast<std::uint32_t>(DeviceFault::NotFinite);
  const StepOutput output = run.glide(blade_down({9.0, top_mm - 30.0, 9.0}), 40);
  EXPECT_EQ(output.sample.world_from_tool, before);
  EXPECT_EQ(output.sample.force_mn, (std::array<std::int32_t, 3>{0, 0, 0}));
  EXPECT_TRUE(has_status(output, ToolStatus::Faulted));
  EXPECT_TRUE(has_status(output, ToolStatus::Running));
}

TEST(Step, AFaultIsOneEventWithItsBitsUntilTheyChange) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.faults = 1;
  run.hold(10);
  run.faults = 3;
  run.hold(10);
  run.faults = 0;
  run.hold(10);
  run.faults = 4;
  run.hold(10);
  const auto faults = run.events(CutEventKind::Fault);
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].value, 1);
  EXPECT_EQ(faults[1].value, 3);
  EXPECT_EQ(faults[2].value, 4);
}

TEST(Step, ASampleCarriesTheLastTickOfItsLine) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.ticks_per_line = 3;
  const StepOutput three = run.hold(1);
  run.ticks_per_line = 2;
  const StepOutput two = run.hold(1);
  EXPECT_EQ(three.sample.tick, 3);  // the start was tick 0
  EXPECT_EQ(two.sample.tick, 5);
}

TEST(Step, LinesOfThreeTicksSawAboutAsFarAsThreeTimesAsManyLines) {
  const Bone bone = block();
  SimulationRun one(bone, blade_down({0.0, above_mm, 0.0}));
  SimulationRun three(bone, blade_down({0.0, above_mm, 0.0}));
  one.glide(blade_down({0.0, top_mm - 8.0, 0.0}), 900);
  three.ticks_per_line = 3;
  three.glide(blade_down({0.0, top_mm - 8.0, 0.0}), 300);
  EXPECT_EQ(one.recording().samples.back().tick, three.recording().samples.back().tick);
  EXPECT_LT(one.bone_from_tool().translation_mm.y, top_mm - 1.0);
  EXPECT_NEAR(one.bone_from_tool().translation_mm.y, three.bone_from_tool().translation_mm.y, 0.1);
}

TEST(Step, SwitchesAndContactAreInTheStatus) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  run.switches = tests::saw_runs | static_cast<std::uint32_t>(Switch::Irrigates);
  saw_into(run);
  const std::uint32_t status = run.recording().samples.back().status;
  for (const ToolStatus bit : {ToolStatus::SawOn, ToolStatus::Irrigated, ToolStatus::InContact,
                               ToolStatus::Cutting, ToolStatus::InKerf}) {
    EXPECT_TRUE(has(status, bit)) << static_cast<std::uint32_t>(bit);
  }
}

/// Nodes in which the step's first kerf differs from one that followed the record, and nodes that
/// are open.
struct FieldComparison {
  std::int64_t open_count = 0, difference_count = 0;
};

FieldComparison compare_with_record(const SimulationRun& run, const Bone& bone) {
  KerfSet followed({}, bone.world_from_bone);
  followed.freeze(run.events(CutEventKind::PlaneFrozen).at(0).pose);
  for (const ToolSample& sample : run.recording().samples) followed.apply(sample);
  const FieldGrid& grid = followed.field(0).grid();
  FieldComparison result;
  for (std::int32_t v = 0; v < grid.v_count; ++v) {
    for (std::int32_t u = 0; u < grid.u_count; ++u) {
      const float inside_mm = followed.field(0).at(u, v);
      if (inside_mm > 0.0F) ++result.open_count;
      if (inside_mm != run.simulation().kerfs().field(0).at(u, v)) ++result.difference_count;
    }
  }
  return result;
}

TEST(Step, TheKerfIsOpenWhereTheRecordedPosesWere) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  saw_into(run);
  const FieldComparison result = compare_with_record(run, bone);
  EXPECT_GT(result.open_count, 10000);
  EXPECT_EQ(result.difference_count, 0);
}

TEST(Step, PausesAndFaultsBreakTheSweepForTheStepAsForThoseWhoFollowTheRecord) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({0.0, above_mm, 0.0}));
  saw_into(run);
  run.hold(200);
  // While nothing moves the tool the hand goes back and aside: the blade's way there was never
  // swept.
  run.step({command(CommandKind::Pause)});
  run.glide(blade_down({0.0, top_mm - 0.1, 3.0}), 1);
  run.step({command(CommandKind::Resume)});
  run.hold(5);
  run.faults = 1;
  run.glide(blade_down({0.0, top_mm - 8.0, -1.0}), 1);
  run.faults = 0;
  run.hold(20);
  EXPECT_EQ(compare_with_record(run, bone).difference_count, 0);
}

TEST(Step, ResumeBeforeTheStartStartsNothing) {
  const Bone bone = block();
  const TissueMap tissue{bone};
  Simulation simulation(tissue, {bone});
  TapeLine line;
  line.command_count = 1;
  line.commands[0] = command(CommandKind::Resume);
  const StepOutput output = simulation.step({line, {}});
  EXPECT_FALSE(has_status(output, ToolStatus::Running));
}

TEST(Step, TheSameInputGivesTheSameOutput) {
  const Bone bone = block();
  SimulationRun one(bone, blade_down({0.0, above_mm, 0.0}, 0.2));
  SimulationRun other(bone, blade_down({0.0, above_mm, 0.0}, 0.2));
  for (SimulationRun* run : {&one, &other}) {
    run->glide(blade_down({0.3, top_mm - 8.0, 0.4}, 0.25), 700);
  }
  EXPECT_EQ(one.recording().samples, other.recording().samples);
  EXPECT_EQ(one.recording().events, other.recording().events);
  EXPECT_GE(one.recording().events.size(), 3U);
}

}  // namespace
}  // namespace hallux::simulator
