#include "tests/benchmarks/fragments/attempt_memory.h"

#include <malloc.h>

#include <algorithm>
#include <deque>
#include <fstream>
#include <stdexcept>

#include "simulator/jobs/live_cut.h"

namespace hallux::benchmarks {

namespace {

/// A picture's, and of the looks at memory.
constexpr std::size_t ticks_of_frame = 16, ticks_of_look = 256;
/// Touched by the step at its start (simulation.cpp).
constexpr std::size_t tiles_ready_at_start = 2048;

/// Private pages of this process; blocks that were freed are given back before.
double resident_mb() {
  malloc_trim(0);
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kib = 0.0;
    if (word == "RssAnon:" && status >> kib) return kib / 1024.0;
  }
  throw std::runtime_error("/proc/self/status says no RssAnon");
}

/// The window's part: base and patch of the kerf that grows, fragments that are due.
class LivePicture {
 public:
  explicit LivePicture(const simulator::BoneToCut& bone) : cut_(bone, shaft_tray()) {}

  void apply(const simulator::StepOutput& output) {
    for (const simulator::CutEvent& event : output.events) cut_.apply(event);
    cut_.apply(output.sample);
    for (const simulator::JobRequest& request : output.requests) cut_.apply(request);
  }
  void draw() {
    if (!cut_.is_due()) return;
    if (auto base = cut_.take_base()) base_ = std::move(*base);
    cut_.build_patch(patch_);
    for (simulator::DueFragment& due : cut_.take_due()) {
      const auto number = static_cast<std::size_t>(due.fragment);
      if (number >= fragments_.size()) fragments_.resize(number + 1);
      fragments_[number] = std::move(due);
    }
    if (auto pieces = cut_.take_free_pieces()) pieces_ = std::move(*pieces);
  }

 private:
  simulator::LiveCut cut_;
  simulator::PatchBase base_;
  simulator::SolidPatch patch_;
  std::vector<simulator::DueFragment> fragments_;
  std::vector<simulator::FreedPiece> pieces_;
};

double attempt_mb(const simulator::Bone& bone, const DrivenRecording& driven) {
  const simulator::TissueMap tissue(bone);
  const simulator::WholeBone whole(solid_of(bone));
  const simulator::BoneToCut to_cut{whole, bone.world_from_bone};
  const double before_mb = resident_mb();
  simulator::Simulation simulation(tissue, {bone, shaft_tray()});
  simulator::ImmediateJobs jobs(std::span(&to_cut, 1), shaft_tray());
  LivePicture picture(to_cut);
  double most_mb = 0.0;
  for (std::size_t i = 0; i < driven.recording.tape.size(); ++i) {
    const simulator::TapeLine& line = driven.recording.tape[i];
    simulator::StepInput input{line, {}};
    for (std::size_t c = 0; c < line.command_count; ++c) {
      if (line.commands[c].kind == simulator::CommandKind::ApplyJob)
        input.job_results[c] = jobs.take(line.commands[c].argument);
    }
    const simulator::StepOutput output = simulation.step(input);
    jobs.apply(output);
    picture.apply(output);
    if (i % ticks_of_frame == 0) picture.draw();
    if (i % ticks_of_look == 0) most_mb = std::max(most_mb, resident_mb() - before_mb);
  }
  return std::max(most_mb, resident_mb() - before_mb);
}

/// As the three follow the record.
double kerfs_mb(const simulator::Bone& bone, const DrivenRecording& driven) {
  const double before_mb = resident_mb();
  std::deque<simulator::KerfSet> sets;
  for (int set = 0; set < 3; ++set) sets.emplace_back(shaft_tray(), bone.world_from_bone);
  sets.front().make_tiles_ready(tiles_ready_at_start, tiles_ready_at_start);
  auto event = driven.recording.events.begin();
  for (const simulator::ToolSample& sample : driven.recording.samples) {
    for (; event != driven.recording.events.end() && event->tick <= sample.tick; ++event) {
      for (simulator::KerfSet& set : sets) set.apply(*event);
    }
    for (simulator::KerfSet& set : sets) set.apply(sample);
  }
  return resident_mb() - before_mb;
}

}  // namespace

AttemptMemory memory_of(const simulator::Bone& bone, const DrivenRecording& driven) {
  return {kerfs_mb(bone, driven), attempt_mb(bone, driven)};
}

}  // namespace hallux::benchmarks
