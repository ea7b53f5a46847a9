/// The step takes nothing from the heap and gives nothing back, whatever happens in it. Jobs do,
/// and run outside of what is counted.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::kinds_of;

std::vector<DangerCapsule> zones_below() {
  return std::vector<DangerCapsule>(danger_zone_limit, {{-9.0, -5.0, 0.0}, {9.0, -5.0, 0.0}, 1.0});
}

/// The hand is led to the first cut's plane, half a millimetre beside its way.
ContactSettings guided() {
  ContactSettings settings;
  settings.guide = {Guidance::Slot, {GuidePlane{Vec3(1.0, 0.0, 0.0), 4.0}}};
  return settings;
}

/// A hundred thousand lines under a guide: a scratch, a saw started on the bone, two cuts through
/// the block, a piece picked up, a hinge that is not there, a pause and a fault; then a blade laid
/// on what is left, pressed and slid about.
Recording eventful_attempt(const Bone& bone) {
  tests::SimulationRun run(bone, blade_down({6.0, 3.0, 0.0}), {}, guided(), zones_below());
  run.glide(blade_down({6.0, 0.5, 0.0}), 70);
  run.glide(blade_down({6.0, 4.0, 0.0}), 600);
  run.switches = 0;
  run.glide(blade_down({6.0, 1.8, 0.0}), 100);
  run.switches = tests::saw_runs;
  run.hold(10);
  for (const double x_mm : {6.0, -6.0}) {
    run.glide(blade_down({x_mm, 4.0, 0.0}), 200);
    run.glide(blade_down({x_mm, -8.0, 0.0}), 1000);
    run.hold(1000);
    run.glide(blade_down({x_mm, 4.0, 0.0}), 200);
  }
  run.step({{CommandKind::PickUp, 1, 0}, {CommandKind::Pause, 0, 0}, {CommandKind::Resume, 0, 0}});
  run.step({{CommandKind::CloseHinge, 0, 0}});
  run.faults = 1;
  run.hold(5);
  run.faults = 0;
  run.glide(blade_down({0.0, 0.0, 0.3}, 0.05), 3000);
  run.step({{CommandKind::StepDone, 1, 0}});
  const Quat flat = rotation_from_axes(Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, 1.0});
  double side = 1.0;
  while (run.recording().tape.size() < 100000) {
    run.glide({flat, {8.0, 4.0, 0.0}}, 300);
    run.glide({flat, {6.0, 0.5, 2.0 * side}}, 700);
    run.glide({flat, {9.0, 0.5, -3.0 * side}}, 1000);
    side = -side;
  }
  return run.recording();
}

struct HeapCalls {
  std::uint64_t allocations = 0, frees = 0;
};

/// The tape once more through a step of its own; the heap calls of Simulation::step alone.
HeapCalls heap_calls_of_steps(const Bone& bone, const Recording& recording) {
  const TissueMap tissue{bone};
  Simulation simulation(tissue, {bone, {}, guided(), {}, zones_below()});
  ImmediateJobs jobs(bone, {});
  HeapCalls calls;
  for (const TapeLine& line : recording.tape) {
    StepInput input{line, {}};
    for (std::size_t i = 0; i < line.command_count; ++i) {
      if (line.commands[i].kind == CommandKind::ApplyJob) {
        input.job_results[i] = jobs.take(line.commands[i].argument);
      }
    }
    const HeapCalls before{tests::allocations_of_this_thread(), tests::frees_of_this_thread()};
    const StepOutput output = simulation.step(input);
    calls.allocations += tests::allocations_of_this_thread() - before.allocations;
    calls.frees += tests::frees_of_this_thread() - before.frees;
    jobs.apply(output);
  }
  return calls;
}

TEST(StepAllocation, AHundredThousandEventfulStepsTakeNothingFromTheHeap) {
  const Bone bone = tests::cancellous_bone(tests::solid_block({20.0, 4.0, 6.0}));
  const Recording recording = eventful_attempt(bone);
  ASSERT_GE(recording.tape.size(), 100000U);
  const auto kinds = kinds_of(recording);
  for (const CutEventKind kind :
       {CutEventKind::Scratch, CutEventKind::Contact, CutEventKind::PlaneFrozen,
        CutEventKind::SectionKnown, CutEventKind::Breakthrough, CutEventKind::SectionCovered,
        CutEventKind::PieceFreed, CutEventKind::PieceRemoved, CutEventKind::StepDone,
        CutEventKind::Paused, CutEventKind::Fault, CutEventKind::BoneHot,
        CutEventKind::DangerContact, CutEventKind::DangerLeft, CutEventKind::Kick,
        CutEventKind::HingeRefused}) {
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), kind), kinds.end()) << static_cast<int>(kind);
  }
  const auto is_led = [](const ToolSample& sample) {
    return !has(sample.status, ToolStatus::InContact) && sample.force_mn[0] != 0;
  };
  EXPECT_TRUE(std::any_of(recording.samples.begin(), recording.samples.end(), is_led));
  const HeapCalls calls = heap_calls_of_steps(bone, recording);
  EXPECT_EQ(calls.allocations, 0U);
  EXPECT_EQ(calls.frees, 0U);
}

}  // namespace
}  // namespace hallux::simulator
