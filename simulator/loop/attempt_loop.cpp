/// One line of the tape at a time: read the device, add commands and ready jobs, step, give the
/// device its force, hand on what came out. In real time each line has a deadline of its own; ticks
/// that were missed go into the next line, and beyond three of them, or where a ring is nearly
/// full, the attempt pauses instead of jumping on. In virtual time the loop waits for room. Nothing
/// here decides about bone: the same tape gives the same outputs without this file.
#include "simulator/loop/attempt_loop.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "simulator/base/progress.h"
#include "simulator/base/time_spread.h"
#include "simulator/loop/clock_watch.h"
#include "simulator/loop/locked_memory.h"
#include "simulator/loop/priority.h"

namespace hallux::simulator {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds tick_time{1};
constexpr std::int64_t ticks_per_progress = 512;
/// A device that was gone for longer pauses the attempt until it is there again.
constexpr std::int64_t lost_ticks_at_most = 200;
/// While it waits for room, each of them a tick long.
constexpr std::int64_t rests_per_progress = 100;
/// How long the worst lateness is shown.
constexpr std::int64_t lines_per_lateness = 1000;

double microseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::micro>(duration).count();
}

/// The attempt while it runs; one object per call of run_attempt.
class AttemptRun {
 public:
  AttemptRun(const AttemptSetup& setup, HapticDevice& device, AttemptChannels& channels,
             const Progress& progress)
      : setup_(setup),
        device_(device, setup.simulation, setup.force_law),
        channels_(channels),
        progress_(progress),
        tissues_(setup.simulation.bones()),
        simulation_(tissues_.all(), setup.simulation) {
    if (setup.job_runner != nullptr) {
      jobs_ = setup.job_runner;
      return;
    }
    const SimulationSetup& simulated = setup.simulation;
    whole_.emplace(simulated, setup.wholes);
    if (setup.pacing == Pacing::RealTime) {
      own_jobs_ = std::make_unique<ThreadedJobs>(whole_->all(), simulated.tray, simulated.bridges);
    } else {
      own_jobs_ = std::make_unique<ImmediateJobs>(whole_->all(), simulated.tray, simulated.bridges);
    }
    jobs_ = own_jobs_.get();
  }

  LoopStatistics run() {
    std::optional<RealTimePriority> priority;
    std::optional<LockedMemory> memory;
    if (setup_.pacing == Pacing::RealTime && (setup_.watch != nullptr || device_.has_motors())) {
      memory.emplace();
      priority.emplace();
    }
    statistics_.has_priority = view_.has_priority = priority && priority->is_granted();
    statistics_.has_locked_memory = view_.has_locked_memory = memory && memory->is_granted();
    statistics_.force_scale = device_.scale();
    statistics_.force_law = setup_.force_law;
    std::exception_ptr failure;
    try {
      operate();
    } catch (...) {
      failure = std::current_exception();
    }
    device_.release();
    if (simulation_.is_over()) statistics_.end = AttemptEnd::Finished;
    channels_.closed.store(true, std::memory_order_release);
    if (setup_.watch != nullptr) close_watch();
    if (!failure) failure = jobs_->failure();
    if (failure) std::rethrow_exception(failure);
    summarise();
    return statistics_;
  }

 private:
  void operate() {
    deadline_ = Clock::now() + tick_time;
    while (tick_ <= setup_.last_tick && !simulation_.is_over() && !is_cut_short()) {
      const std::int64_t ticks = setup_.pacing == Pacing::RealTime ? wait_for_tick() : 1;
      if (is_cut_short()) return;
      advance(ticks);
      if (statistics_.lines % ticks_per_progress == 0) tell_progress();
    }
  }

  /// A recorder or a job that failed, or whoever watches the progress, ends it; also while it
  /// waits.
  bool is_cut_short() noexcept {
    if (channels_.recorder_failed.load(std::memory_order_relaxed)) {
      statistics_.end = AttemptEnd::RecorderFailed;
    }
    return statistics_.end != AttemptEnd::ReachedLastTick || jobs_->failure() != nullptr;
  }

  void tell_progress() {
    if (setup_.pacing == Pacing::RealTime) clocks_.observe(read_clocks());
    if (progress_ && !progress_(fraction_done())) statistics_.end = AttemptEnd::Cancelled;
  }

  double fraction_done() const {
    if (setup_.attempt_operator != nullptr) return setup_.attempt_operator->fraction_done();
    return static_cast<double>(tick_) /
           static_cast<double>(std::max<std::int64_t>(1, setup_.last_tick));
  }

  void summarise() {
    statistics_.ticks = tick_;
    statistics_.unsampled_us =
        std::chrono::duration_cast<std::chrono::microseconds>(unsampled_).count();
    statistics_.clock_steps = clocks_.steps();
    statistics_.step_p50_us = step_times_.at_us(0.5);
    statistics_.step_p99_us = step_times_.at_us(0.99);
    statistics_.step_max_us = step_times_.greatest_us();
    statistics_.late_p50_us = late_times_.at_us(0.5);
    statistics_.late_p99_us = late_times_.at_us(0.99);
    statistics_.late_max_us = late_times_.greatest_us();
  }

  /// Sleeps until the next deadline; the ticks that this line must cover.
  std::int64_t wait_for_tick() {
    std::this_thread::sleep_until(deadline_);
    const Clock::duration late = Clock::now() - deadline_;
    late_times_.add(late);
    late_max_us_ = std::max(late_max_us_, microseconds(late));
    const std::int64_t missed = late / tick_time;
    if (missed >= ticks_per_line_max || must_wait()) return pause_gap();
    deadline_ += tick_time * (1 + missed);
    statistics_.missed_ticks += missed;
    return 1 + missed;
  }

  /// Somebody who follows has no room left.
  bool must_wait() noexcept {
    return is_storage_full() || fullest_ring_share() > 0.875 || !jobs_->has_room();
  }

  bool is_storage_full() const noexcept {
    return channels_.storage_full.load(std::memory_order_relaxed);
  }

  double fullest_ring_share() noexcept {
    const auto share = [](const auto& ring) {
      return static_cast<double>(ring.size()) / static_cast<double>(ring.capacity());
    };
    const double recorder =
        std::max({share(channels_.tape), share(channels_.samples), share(channels_.events)});
    statistics_.ring_share_max = std::max(statistics_.ring_share_max, recorder);
    return setup_.watch == nullptr ? recorder : std::max(recorder, share(setup_.watch->feed));
  }

  /// What a live display follows: all that opens bone, and the newest view.
  void show(const StepOutput& output) {
    AttemptWatch& watch = *setup_.watch;
    for (const CutEvent& event : output.events) push(watch.feed, GeometryFeed{event});
    push(watch.feed, GeometryFeed{output.sample});
    for (const JobRequest& request : output.requests) push(watch.feed, GeometryFeed{request});
    if (statistics_.lines % lines_per_lateness == 0) {
      view_.late_us = std::exchange(late_max_us_, 0.0);
    }
    view_.sample = output.sample;
    view_.engaged = output.engaged;
    view_.hottest_celsius = output.hottest_celsius;
    view_.lines = statistics_.lines;
    view_.missed_ticks = statistics_.missed_ticks;
    view_.pauses = statistics_.pauses;
    view_.ring_share = fullest_ring_share();
    view_.is_device_lost = is_device_lost();
    view_.device_force_newton = device_.force_newton();
    view_.force_limits = device_.limits();
    watch.view.write(view_);
  }

  void close_watch() noexcept {
    view_.is_over = true;
    setup_.watch->view.write(view_);
    setup_.watch->closed.store(true, std::memory_order_release);
  }

  /// Simulated time stands still over a gap: the step hears Pause now and Resume at the next line.
  std::int64_t pause_gap() {
    ++statistics_.pauses;
    is_gap_ = true;
    device_.release();
    Clock::duration for_storage{};
    for (std::int64_t rests = 1; must_wait() && !is_cut_short(); ++rests) {
      const Clock::time_point before = Clock::now();
      const bool is_for_storage = is_storage_full();
      show_storage(is_for_storage);
      std::this_thread::sleep_for(tick_time);
      device_.release();
      if (is_for_storage) for_storage += Clock::now() - before;
      if (rests % rests_per_progress == 0) tell_progress();
    }
    show_storage(false);
    const Clock::time_point now = Clock::now();
    unsampled_ += now - deadline_ - for_storage;
    deadline_ = now + tick_time;
    return 1;
  }

  /// No line is made meanwhile that could show it.
  void show_storage(bool is_full) noexcept {
    if (view_.is_storage_full == is_full) return;
    view_.is_storage_full = is_full;
    if (setup_.watch != nullptr) setup_.watch->view.write(view_);
  }

  void advance(std::int64_t ticks) {
    TapeLine line;
    line.tick = tick_;
    line.ticks = static_cast<std::uint8_t>(ticks);
    line.device = device_.read(tick_ + ticks - 1, ticks);
    note_loss(line.device, ticks);
    std::array<JobResult*, commands_per_tick> results{};
    add_commands(line, results);

    const Clock::time_point before = Clock::now();
    const StepOutput output = simulation_.step({line, results});
    step_times_.add(Clock::now() - before);

    device_.set_force(output, ticks);
    if (setup_.attempt_operator != nullptr) setup_.attempt_operator->observe(output);
    statistics_.force_limits |= device_.limits();
    statistics_.has_changed_device = device_.is_handed_over();
    const bool is_running = has(output.sample.status, ToolStatus::Running);
    if (line.device.faults != 0 && is_running) statistics_.faulted_ticks += ticks;
    push(channels_.tape, line);
    for (const CutEvent& event : output.events) push(channels_.events, event);
    push(channels_.samples, output.sample);
    CHECK(jobs_->apply(output));
    tick_ += ticks;
    ++statistics_.lines;
    if (setup_.watch != nullptr) show(output);
  }

  /// Of a device that is gone, so long that nobody operates any more.
  void note_loss(const DeviceState& device, std::int64_t ticks) noexcept {
    const bool was_lost = is_device_lost();
    lost_ticks_ = has(device.faults, DeviceFault::Lost) ? lost_ticks_ + ticks : 0;
    if (!was_lost && is_device_lost()) ++statistics_.pauses;
  }
  bool is_device_lost() const noexcept { return lost_ticks_ > lost_ticks_at_most; }

  void add_commands(TapeLine& line, std::array<JobResult*, commands_per_tick>& results) noexcept {
    const auto add = [&](const Command& command, JobResult* result) {
      results[line.command_count] = result;
      line.commands[line.command_count++] = command;
    };
    const bool is_held = is_gap_ || is_device_lost();
    if (is_held != is_paused_) {
      add({is_held ? CommandKind::Pause : CommandKind::Resume, paused_by_loop, 0}, nullptr);
    }
    is_paused_ = is_held;
    is_gap_ = false;
    while (line.command_count < commands_per_tick && next_command_ < setup_.commands.size() &&
           setup_.commands[next_command_].tick < line.tick + line.ticks) {
      add(setup_.commands[next_command_++].command, nullptr);
    }
    Command live;
    while (setup_.attempt_operator != nullptr && line.command_count < commands_per_tick &&
           setup_.attempt_operator->take_command(live)) {
      add(live, nullptr);
    }
    while (setup_.watch != nullptr && line.command_count < commands_per_tick &&
           setup_.watch->commands.pop(live)) {
      add(live, nullptr);
    }
    while (line.command_count < commands_per_tick) {
      JobResult* const result = jobs_->take_ready();
      if (result == nullptr) break;
      add({CommandKind::ApplyJob, result->request.id, result->request.tick}, result);
    }
  }

  template <typename Value>
  void push(Ring<Value>& ring, const Value& value) {
    while (!ring.push(value)) {
      // In real time the ring is drained before it fills; a recorder that failed drains nothing any
      // more.
      if (channels_.recorder_failed.load(std::memory_order_relaxed)) return;
      CHECK(setup_.pacing == Pacing::Virtual);
      std::this_thread::sleep_for(std::chrono::microseconds{50});
    }
  }

  const AttemptSetup& setup_;
  DeviceLink device_;
  AttemptChannels& channels_;
  const Progress& progress_;
  TissueMaps tissues_;
  Simulation simulation_;
  std::optional<WholeBones> whole_;      ///< none where the setup brings its own jobs
  std::unique_ptr<JobRunner> own_jobs_;  ///< none where the setup brings its own
  JobRunner* jobs_ = nullptr;
  TimeSpread step_times_, late_times_;
  LoopStatistics statistics_;
  LoopView view_;
  double late_max_us_ = 0.0;  ///< since the view showed it last
  Clock::time_point deadline_;
  Clock::duration unsampled_{};  ///< that the hand moved in gaps
  ClockWatch clocks_;
  std::int64_t tick_ = 0;
  std::size_t next_command_ = 0;
  /// Since the device was there last.
  std::int64_t lost_ticks_ = 0;
  bool is_gap_ = false;
  /// Held by the loop.
  bool is_paused_ = false;
};

}  // namespace

LoopStatistics run_attempt(const AttemptSetup& setup, HapticDevice& device,
                           AttemptChannels& channels, const Progress& progress) {
  return AttemptRun(setup, device, channels, progress).run();
}

}  // namespace hallux::simulator
