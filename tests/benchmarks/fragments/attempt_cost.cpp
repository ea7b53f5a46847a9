#include "tests/benchmarks/fragments/attempt_cost.h"

#include "tests/benchmarks/report/percentiles.h"
#include "tests/support/allocation_counter.h"

namespace hallux::benchmarks {

namespace {

const MeasuredWork* work_at(const DrivenRecording& driven, std::size_t line) {
  for (const MeasuredWork& work : driven.works) {
    if (line >= work.begin && line < work.end) return &work;
  }
  return nullptr;
}

std::uint64_t heap_calls() {
  return tests::allocations_of_this_thread() + tests::frees_of_this_thread();
}

simulator::StepOutput timed_step(simulator::Simulation& simulation,
                                 const simulator::StepInput& input, std::vector<double>& times_us,
                                 AttemptCost& cost) {
  const std::uint64_t calls = heap_calls();
  const Stopwatch watch;
  const simulator::StepOutput output = simulation.step(input);
  const double took_us = 1000.0 * watch.worked_milliseconds();
  cost.heap_calls += heap_calls() - calls;
  times_us.push_back(took_us);
  return output;
}

}  // namespace

void step_through(const simulator::Bone& bone, const DrivenRecording& driven, AttemptCost& cost) {
  const simulator::TissueMap tissue(bone);
  simulator::Simulation simulation(tissue, {bone, shaft_tray()});
  simulator::ImmediateJobs jobs(bone, shaft_tray());
  for (std::size_t i = 0; i < driven.recording.tape.size(); ++i) {
    const simulator::TapeLine& line = driven.recording.tape[i];
    simulator::StepInput input{line, {}};
    for (std::size_t c = 0; c < line.command_count; ++c) {
      if (line.commands[c].kind != simulator::CommandKind::ApplyJob) continue;
      input.job_results[c] = jobs.take(line.commands[c].argument);
    }
    const MeasuredWork* const work = work_at(driven, i);
    jobs.apply(work == nullptr ? simulation.step(input)
                               : timed_step(simulation, input, cost.times_us[work->what], cost));
  }
}

}  // namespace hallux::benchmarks
