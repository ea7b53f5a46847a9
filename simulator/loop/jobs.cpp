#include "simulator/loop/jobs.h"

#include <algorithm>
#include <chrono>

namespace hallux::simulator {

namespace {

/// A minute of samples at 1 kHz, and their events.
constexpr std::size_t feed_capacity = 65536;
constexpr std::size_t ready_capacity = 256;
/// How long the worker rests when there is nothing to do: a lock on the haptic thread is dearer
/// than a late job.
constexpr std::chrono::microseconds idle_rest{500};

}  // namespace

TissueMaps::TissueMaps(std::span<const Bone* const> bones) {
  for (const Bone* bone : bones) maps_.push_back(&made_.emplace_back(*bone));
}

WholeBones::WholeBones(const SimulationSetup& setup, std::span<const WholeBone* const> had) {
  for (const Bone* bone : setup.bones()) {
    const bool is_had = bones_.size() < had.size();
    if (!is_had) own_.push_back(std::make_unique<const WholeBone>(solid_of(*bone)));
    bones_.push_back({is_had ? *had[bones_.size()] : *own_.back(), bone->world_from_bone});
  }
}

bool ImmediateJobs::apply(const StepOutput& output) {
  for (const CutEvent& event : output.events) geometry_.apply(event);
  geometry_.apply(output.sample);
  for (const JobResult* result : output.given_back) results_.take_back(result);
  for (const JobRequest& request : output.requests) {
    ready_.push_back(results_.lend(geometry_.run(request)));
  }
  return true;
}

JobResult* ImmediateJobs::take_ready() noexcept {
  return ready_.empty() ? nullptr : take(ready_.front()->request.id);
}

JobResult* ImmediateJobs::take(std::int32_t job) noexcept {
  const auto found = std::find_if(ready_.begin(), ready_.end(), [job](const JobResult* result) {
    return result->request.id == job;
  });
  if (found == ready_.end()) return nullptr;
  JobResult* const result = *found;
  ready_.erase(found);
  return result;
}

ThreadedJobs::ThreadedJobs(std::span<const BoneToCut> bones, const Tray& tray,
                           const PlannedBridges& bridges)
    : geometry_(bones, tray, bridges),
      feed_(feed_capacity),
      ready_(ready_capacity),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

ThreadedJobs::~ThreadedJobs() = default;

bool ThreadedJobs::apply(const StepOutput& output) {
  bool has_room = true;
  for (const CutEvent& event : output.events) has_room = feed_.push(event) && has_room;
  has_room = feed_.push(output.sample) && has_room;
  for (const JobResult* result : output.given_back) has_room = feed_.push(result) && has_room;
  for (const JobRequest& request : output.requests) has_room = feed_.push(request) && has_room;
  return has_room;
}

bool ThreadedJobs::has_room() const noexcept { return feed_.size() < feed_.capacity() / 8 * 7; }

JobResult* ThreadedJobs::take_ready() noexcept {
  JobResult* result = nullptr;
  return ready_.pop(result) ? result : nullptr;
}

std::exception_ptr ThreadedJobs::failure() const noexcept {
  return has_failed_.load(std::memory_order_acquire) ? thrown_ : nullptr;
}

void ThreadedJobs::work(const std::stop_token& stop) {
  try {
    Feed feed;
    while (!stop.stop_requested()) {
      if (feed_.pop(feed)) {
        apply(feed, stop);
      } else {
        std::this_thread::sleep_for(idle_rest);
      }
    }
  } catch (...) {
    thrown_ = std::current_exception();
    has_failed_.store(true, std::memory_order_release);
  }
}

void ThreadedJobs::apply(const Feed& feed, const std::stop_token& stop) {
  if (const auto* sample = std::get_if<ToolSample>(&feed)) geometry_.apply(*sample);
  if (const auto* event = std::get_if<CutEvent>(&feed)) geometry_.apply(*event);
  if (const auto* result = std::get_if<const JobResult*>(&feed)) results_.take_back(*result);
  const auto* request = std::get_if<JobRequest>(&feed);
  if (request == nullptr) return;
  JobResult* const result = results_.lend(geometry_.run(*request));
  while (!ready_.push(result) && !stop.stop_requested()) {
    std::this_thread::sleep_for(idle_rest);
  }
}

}  // namespace hallux::simulator
