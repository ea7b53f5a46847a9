#include "simulator/loop/replay.h"

#include "simulator/base/progress.h"
#include "simulator/loop/jobs.h"

namespace hallux::simulator {

namespace {

constexpr std::size_t lines_per_progress = 512;

class ReplayRun {
 public:
  ReplayRun(const Recording& recording, const SimulationSetup& setup)
      : recording_(recording),
        tissues_(setup.bones()),
        simulation_(tissues_.all(), setup),
        whole_(setup),
        jobs_(whole_.all(), setup.tray, setup.bridges) {
    outputs_.engine = recording.engine;
    outputs_.samples.reserve(recording.samples.size());
    outputs_.events.reserve(recording.events.size());
  }

  ReplayResult run(const Progress& progress) {
    for (std::size_t i = 0; i < recording_.tape.size() && result_.difference.empty(); ++i) {
      advance(recording_.tape[i]);
      const double done = static_cast<double>(i) / static_cast<double>(recording_.tape.size());
      if (i % lines_per_progress == 0 && progress && !progress(done)) {
        differ(recording_.tape[i].tick, "the replay was cancelled");
      }
    }
    if (result_.difference.empty()) compare_counts();
    result_.is_identical = result_.difference.empty();
    result_.samples = static_cast<std::int64_t>(outputs_.samples.size());
    result_.outputs = digest_outputs(outputs_);
    result_.bone = digest_of_mesh(jobs_.geometry().solid().mesh);
    return result_;
  }

 private:
  void differ(std::int64_t tick, std::string what) {
    result_.first_difference_tick = tick;
    result_.difference = std::move(what);
  }

  /// The results that the line's ApplyJob commands name; false where the tape names a job that was
  /// not asked for.
  bool find_results(const TapeLine& line, StepInput& input) {
    const bool is_possible = line.ticks >= 1 && line.ticks <= ticks_per_line_max &&
                             line.tick == next_tick_ && line.command_count <= commands_per_tick;
    if (!is_possible) {
      differ(next_tick_, "the input tape does not follow on");
      return false;
    }
    for (std::size_t i = 0; i < line.command_count; ++i) {
      if (line.commands[i].kind != CommandKind::ApplyJob) continue;
      input.job_results[i] = jobs_.take(line.commands[i].argument);
      const bool matches = input.job_results[i] != nullptr &&
                           input.job_results[i]->request.tick == line.commands[i].detail;
      if (matches) continue;
      differ(line.tick, "the input tape applies a job that was not asked for");
      return false;
    }
    return true;
  }

  void advance(const TapeLine& line) {
    StepInput input{line, {}};
    if (!find_results(line, input)) return;
    const StepOutput output = simulation_.step(input);
    next_tick_ = line.tick + line.ticks;
    for (const CutEvent& event : output.events) {
      const std::size_t at = outputs_.events.size();
      outputs_.events.push_back(event);
      const bool is_same = at < recording_.events.size() && recording_.events[at] == event;
      if (!is_same) differ(event.tick, "a cut event differs");
    }
    const std::size_t at = outputs_.samples.size();
    outputs_.samples.push_back(output.sample);
    const bool is_same = at < recording_.samples.size() && recording_.samples[at] == output.sample;
    if (!is_same && result_.difference.empty()) differ(output.sample.tick, "a tool sample differs");
    jobs_.apply(output);
  }

  void compare_counts() {
    const bool is_whole = outputs_.samples.size() == recording_.samples.size() &&
                          outputs_.events.size() == recording_.events.size();
    if (!is_whole) differ(next_tick_, "the record holds more than its input gives");
  }

  const Recording& recording_;
  TissueMaps tissues_;
  Simulation simulation_;
  WholeBones whole_;
  ImmediateJobs jobs_;
  Recording outputs_;
  ReplayResult result_;
  std::int64_t next_tick_ = 0;
};

}  // namespace

ReplayResult replay(const Recording& recording, const SimulationSetup& setup,
                    const Progress& progress) {
  return ReplayRun(recording, setup).run(progress);
}

}  // namespace hallux::simulator
