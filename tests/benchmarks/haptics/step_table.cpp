// What one call of the step costs while bone is sawn and while a blade is laid on it.
//
//     step_table [TRIANGLES...]
//
// Bones of 5,000, 50,000 and 500,000 triangles, or as many as are said. Processor time of each
// call, as Markdown.
#include <utility>
#include <vector>

#include "simulator/base/elementary.h"
#include "tests/benchmarks/haptics/tick_costs.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/worlds/bone_like.h"
#include "tests/simulator/step/simulation_run.h"

namespace hallux::benchmarks {

namespace {

using simulator::Bone;
using tests::blade_down;
using tests::SimulationRun;

constexpr double coupling_newton_per_mm = 2.0;

/// At a place of the middle of the shaft, whose surface lies 6 to 8 mm off its axis.
void push_for(SimulationRun& run, const Vec3& place_mm, double force_newton, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    const double lead_mm = force_newton / coupling_newton_per_mm;
    run.glide(blade_down({place_mm.x, run.bone_from_tool().translation_mm.y - lead_mm, place_mm.z}),
              1);
  }
}

/// Each call once more through a step of its own.
Percentiles cost_us(const Bone& bone, const simulator::Recording& recording) {
  const simulator::TissueMap tissue(bone);
  simulator::Simulation simulation(tissue, {bone});
  simulator::ImmediateJobs jobs(bone, {});
  std::vector<double> times_us;
  times_us.reserve(recording.tape.size());
  for (const simulator::TapeLine& line : recording.tape) {
    simulator::StepInput input{line, {}};
    for (std::size_t i = 0; i < line.command_count; ++i) {
      if (line.commands[i].kind != simulator::CommandKind::ApplyJob) continue;
      input.job_results[i] = jobs.take(line.commands[i].argument);
    }
    const Stopwatch watch;
    const simulator::StepOutput output = simulation.step(input);
    times_us.push_back(1000.0 * watch.worked_milliseconds());
    jobs.apply(output);
  }
  return percentiles_of(std::move(times_us));
}

/// Two strokes side by side, the second in the slot of the first.
Percentiles sawn(const Bone& bone) {
  const Vec3 middle = middle_of(bone.outer);
  SimulationRun run(bone, blade_down(middle + Vec3{0.0, 12.0, 0.0}));
  for (const double aside_mm : {-2.0, 2.0}) {
    const Vec3 place = middle + Vec3{0.0, 12.0, aside_mm};
    run.glide(blade_down(place), 300);
    push_for(run, place, 12.0, 4000);
    run.glide(blade_down(place), 300);
  }
  return cost_us(bone, run.recording());
}

/// The blade's face on the shaft, pressed with 6 N, slid and tilted to and fro.
Percentiles laid(const Bone& bone) {
  const Vec3 middle = middle_of(bone.outer);
  const Quat flat = rotation_from_axes(Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, 1.0});
  SimulationRun run(bone, {flat, middle + Vec3{8.0, 12.0, 0.0}});
  run.switches = 0;
  for (int i = 0; i < 4000; ++i) {
    const double swing = elementary::sin(0.003 * i);
    const Vec3 place = middle + Vec3{8.0 + 3.0 * swing, 4.0, 2.0 * swing};
    const Quat tilt = rotation_about(Vec3{1.0, 0.0, 0.0}, 0.1 * swing);
    run.glide({normalised(tilt * flat), place}, 1);
  }
  return cost_us(bone, run.recording());
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  using namespace hallux::benchmarks;
  const TickCosts costs{.program = "step_table",
                        .name = "step_cost",
                        .title = "What a call of the step costs, processor time",
                        .counted = "calls",
                        .work = {{"sawn", sawn}, {"laid on", laid}}};
  return print_tick_costs(costs, count, words);
}
