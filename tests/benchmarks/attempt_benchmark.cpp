// What an attempt costs: each step, each job, the recorder and the replay, over one Silver attempt
// of the expert hand.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "database/course/begin_attempt.h"
#include "database/recording/recorder.h"
#include "scenarios/simulation_setup.h"
#include "simulator/loop/jobs.h"
#include "simulator/loop/replay.h"
#include "simulator/step/simulation.h"
#include "tests/database/some_database.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::tests {

namespace {

using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point before) {
  return std::chrono::duration<double, std::micro>(Clock::now() - before).count();
}

/// Silver's patient with about 100,000 triangles, and the attempt that was recorded on it.
struct RecordedSilver {
  RecordedSilver() : silver(scenarios::load_shipped_scenario("silver")) {
    silver.patient.edge_mm = 0.32;
    bone = make_patient_bones(silver).front();
    recording = run_hand(silver, bone, "expert", 1).recording;
  }

  scenarios::Scenario silver;
  simulator::Bone bone;
  simulator::Recording recording;
};

double simulated_s(const simulator::Recording& recording) {
  return static_cast<double>(recording.samples.size()) / 1000.0;
}

simulator::SimulationSetup setup_of(const RecordedSilver& recorded) {
  return simulation_setup(recorded.silver, recorded.bone, plan_on(recorded.silver, recorded.bone),
                          simulator::Guidance::None);
}

struct Costs {
  std::vector<double> step_us;
  double contact_ms = 0.0, pieces_ms = 0.0;  ///< the longest of each kind
};

/// Steps through the tape again, with a clock around each step and each job.
Costs retrace(const RecordedSilver& recorded) {
  const simulator::TissueMap tissue(recorded.bone);
  const simulator::SimulationSetup setup = setup_of(recorded);
  simulator::Simulation simulation(tissue, setup);
  simulator::ImmediateJobs jobs(recorded.bone, recorded.silver.saw.blade);
  Costs costs;
  costs.step_us.reserve(recorded.recording.tape.size());
  for (const simulator::TapeLine& line : recorded.recording.tape) {
    simulator::StepInput input{line, {}};
    for (std::size_t i = 0; i < line.command_count; ++i) {
      if (line.commands[i].kind != simulator::CommandKind::ApplyJob) continue;
      input.job_results[i] = jobs.take(line.commands[i].argument);
    }
    const Clock::time_point before_step = Clock::now();
    const simulator::StepOutput output = simulation.step(input);
    costs.step_us.push_back(microseconds_since(before_step));
    const Clock::time_point before_jobs = Clock::now();
    jobs.apply(output);
    const double jobs_ms = 0.001 * microseconds_since(before_jobs);
    for (const simulator::JobRequest& request : output.requests) {
      double& longest_ms =
          request.kind == simulator::JobKind::Section ? costs.contact_ms : costs.pieces_ms;
      longest_ms = std::max(longest_ms, jobs_ms);
    }
  }
  return costs;
}

// The times of the steps are in the counters; the benchmark's own time is of the whole attempt.
void steps_and_jobs_of_an_attempt(benchmark::State& state) {
  const RecordedSilver recorded;
  Costs costs;
  for (auto _ : state) costs = retrace(recorded);
  std::sort(costs.step_us.begin(), costs.step_us.end());
  const auto at = [&](double share) {
    return costs
        .step_us[static_cast<std::size_t>(share * static_cast<double>(costs.step_us.size() - 1))];
  };
  state.counters["triangles"] = static_cast<double>(solid_of(recorded.bone).triangles.size());
  state.counters["step_p50_us"] = at(0.5);
  state.counters["step_p99_us"] = at(0.99);
  state.counters["step_max_us"] = at(1.0);
  state.counters["contact_job_ms"] = costs.contact_ms;
  state.counters["pieces_job_ms"] = costs.pieces_ms;
}
BENCHMARK(steps_and_jobs_of_an_attempt)->Iterations(1)->Unit(benchmark::kMillisecond);

void replay_of_an_attempt(benchmark::State& state) {
  const RecordedSilver recorded;
  for (auto _ : state) {
    const simulator::ReplayResult result = replay(recorded.recording, setup_of(recorded));
    if (!result.is_identical) state.SkipWithError("the replay differs");
  }
  state.counters["times_real_time"] = benchmark::Counter(
      simulated_s(recorded.recording), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(replay_of_an_attempt)->Iterations(1)->Unit(benchmark::kMillisecond);

void recording_of_an_attempt(benchmark::State& state) {
  const RecordedSilver recorded;
  const database::TemporaryDirectory directory{database::Medium::Disk};
  database::Database database = database::Database::open(directory.data());
  database::RecorderStatistics statistics;
  for (auto _ : state) {
    simulator::AttemptChannels channels;
    database::Recorder recorder(database, create_attempt(database, some_attempt(database)),
                                channels);
    database::produce(recorded.recording, channels);
    statistics = recorder.finish("{}");
  }
  const double duration_s = simulated_s(recorded.recording);
  state.counters["bytes_per_s"] = static_cast<double>(statistics.bytes) / duration_s;
  state.counters["cpu_ms_per_s"] = 1000.0 * statistics.cpu_s / duration_s;
  state.counters["commit_max_ms"] = 1000.0 * statistics.commit_max_s;
}
BENCHMARK(recording_of_an_attempt)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace hallux::tests
