/// A pass takes what waits in the rings and then commits the windows that were already complete
/// when the pass before began: what the producer has gone beyond was pushed. On a full disk the
/// same window is tried again until there is room or the attempt is given up; meanwhile the loop
/// pauses, so that what waits in memory stays bounded.
#include "database/recording/recorder.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <exception>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>

#include "database/recording/attempts.h"
#include "database/recording/window_writer.h"
#include "database/store/log_size.h"
#include "simulator/base/check.h"

namespace hallux::database {

namespace {

constexpr std::chrono::milliseconds pause_between_passes{10};
/// Somebody frees space by hand; a commit that fails costs a few milliseconds.
constexpr std::chrono::milliseconds pause_between_tries{200};

double thread_cpu_s() noexcept {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// Pops what was waiting at the call, no more: a producer without pause must not keep the pass from
/// ending.
template <typename Row>
std::size_t drain_ring(simulator::Ring<Row>& ring, std::vector<Row>& rows) {
  const std::size_t waiting = ring.size();
  Row row;
  for (std::size_t i = 0; i < waiting && ring.pop(row); ++i) rows.push_back(row);
  return waiting;
}

/// Its window's tick: a line and the sample at its end stand in one window, also where missed ticks
/// lie across the border.
std::int64_t last_tick(const simulator::TapeLine& line) noexcept {
  return line.tick + line.ticks - 1;
}
std::int64_t last_tick(const simulator::ToolSample& sample) noexcept { return sample.tick; }
std::int64_t last_tick(const simulator::CutEvent& event) noexcept { return event.tick; }

/// Takes the rows before `end_tick` off the front, at most as many as one chunk may hold.
template <typename Row>
std::vector<Row> take_before(std::vector<Row>& rows, std::int64_t end_tick) {
  auto last = std::find_if(rows.begin(), rows.end(),
                           [end_tick](const Row& row) { return last_tick(row) >= end_tick; });
  last = std::min(
      last, rows.begin() + static_cast<std::ptrdiff_t>(std::min(rows.size(), rows_per_chunk_max)));
  std::vector<Row> taken{rows.begin(), last};
  rows.erase(rows.begin(), last);
  return taken;
}

/// The window of the earliest row that waits.
std::optional<std::int64_t> first_window(const WindowRows& rows) {
  std::optional<std::int64_t> first_tick;
  const auto look_at = [&first_tick](const auto& stream) {
    if (stream.empty()) return;
    const std::int64_t tick = last_tick(stream.front());
    first_tick = std::min(first_tick.value_or(tick), tick);
  };
  look_at(rows.tape);
  look_at(rows.samples);
  look_at(rows.events);
  if (!first_tick) return std::nullopt;
  return std::max<std::int64_t>(*first_tick, 0) / window_ticks;
}

}  // namespace

class Recorder::Writer {
 public:
  Writer(Database database, WriterLease lease, simulator::AttemptChannels& channels,
         FullDisk full_disk)
      : lease_(std::move(lease)),
        channels_(channels),
        full_disk_(full_disk),
        pen_(std::move(database), lease_.attempt()),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}

  ~Writer() { is_stopping_.store(true, std::memory_order_relaxed); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  RecorderStatistics drain() {
    if (thread_.joinable()) thread_.join();
    if (failure_) std::rethrow_exception(failure_);
    RecorderStatistics statistics = pen_.statistics();
    statistics.cpu_s = cpu_s_;
    statistics.gaps = gaps_;
    statistics.duplicates = duplicates_;
    return statistics;
  }

  void seal(const std::string& quality_json) {
    when_there_is_room([&] {
      seal_attempt(pen_.database(), lease_.attempt(), duration_ticks_, quality_json,
                   pen_.last_link());
    });
    shorten_log(pen_.database());
  }
  void abandon() { abandon_attempt(pen_.database(), lease_.attempt()); }
  const AttemptId& attempt() const noexcept { return lease_.attempt(); }

 private:
  void run(const std::stop_token& stop) noexcept {
    const double start_s = thread_cpu_s();
    try {
      record(stop);
    } catch (...) {
      failure_ = std::current_exception();
      channels_.recorder_failed.store(true, std::memory_order_release);
    }
    cpu_s_ = thread_cpu_s() - start_s;
  }

  void record(const std::stop_token& stop) {
    bool is_last_pass = false;
    while (!is_last_pass) {
      // Rows of ticks before `safe_tick` were pushed before this pass: the producer had gone beyond
      // them.
      const std::int64_t safe_tick = newest_tick_;
      is_last_pass = channels_.closed.load(std::memory_order_acquire) || stop.stop_requested();
      const bool is_hurried = drain_rings() > channels_.samples.capacity() / 4;
      commit_windows(safe_tick);
      if (!is_hurried && !is_last_pass) std::this_thread::sleep_for(pause_between_passes);
    }
    commit_windows(std::nullopt);
    commit_last_facts();
  }

  void commit_last_facts() {
    const WindowRows rows{{}, {}, {}, std::exchange(waiting_.display_facts, {})};
    when_there_is_room([&] { pen_.commit(next_window_, rows); });
  }

  /// Does `write`, again and again where the disk is full and that is waited for. What waits
  /// meanwhile is bounded: the loop pauses within a tick of the flag, and in virtual time the
  /// producer waits for room in its rings.
  template <typename Write>
  void when_there_is_room(Write&& write) {
    for (bool is_done = false; !is_done;) {
      try {
        write();
        is_done = true;
      } catch (const DatabaseError& error) {
        if (error.kind() != DatabaseErrorKind::Full || !may_wait()) throw;
        channels_.storage_full.store(true, std::memory_order_release);
        std::this_thread::sleep_for(pause_between_tries);
      }
    }
    channels_.storage_full.store(false, std::memory_order_release);
  }

  bool may_wait() const noexcept {
    return full_disk_ == FullDisk::IsWaitedFor && !is_stopping_.load(std::memory_order_relaxed) &&
           !channels_.gives_up.load(std::memory_order_relaxed);
  }

  /// The tape covers each tick once, in order; what came beyond `kept` rows is new.
  void count_breaks(std::size_t kept) noexcept {
    for (std::size_t i = kept; i < waiting_.tape.size(); ++i) {
      const simulator::TapeLine& line = waiting_.tape[i];
      if (line.tick > covered_until_) ++gaps_;
      if (line.tick < covered_until_) ++duplicates_;
      covered_until_ = std::max(covered_until_, last_tick(line) + 1);
    }
  }

  std::size_t drain_rings() {
    const std::size_t kept = waiting_.tape.size();
    const std::size_t drained = drain_ring(channels_.tape, waiting_.tape) +
                                drain_ring(channels_.samples, waiting_.samples) +
                                drain_ring(channels_.events, waiting_.events);
    count_breaks(kept);
    // Beyond that the ring fills: the window then drops what was shown, and counts it.
    if (waiting_.display_facts.size() < channels_.display_facts.capacity())
      drain_ring(channels_.display_facts, waiting_.display_facts);
    if (!waiting_.tape.empty()) {
      const simulator::TapeLine& line = waiting_.tape.back();
      newest_tick_ = std::max(newest_tick_, line.tick);
      duration_ticks_ = std::max(duration_ticks_, last_tick(line) + 1);
    }
    if (!waiting_.samples.empty()) {
      newest_tick_ = std::max(newest_tick_, waiting_.samples.back().tick);
      duration_ticks_ = std::max(duration_ticks_, waiting_.samples.back().tick + 1);
    }
    return drained;
  }

  /// Commits the windows that end before `safe_tick`, or all of them.
  void commit_windows(std::optional<std::int64_t> safe_tick) {
    for (auto seq = first_window(waiting_); seq; seq = first_window(waiting_)) {
      const std::int64_t window = std::max(*seq, next_window_);
      const std::int64_t end_tick = (window + 1) * window_ticks;
      if (safe_tick && end_tick > *safe_tick) return;
      WindowRows rows{take_before(waiting_.tape, end_tick), take_before(waiting_.samples, end_tick),
                      take_before(waiting_.events, end_tick),
                      std::exchange(waiting_.display_facts, {})};
      when_there_is_room([&] { pen_.commit(window, rows); });
      next_window_ = window + 1;
    }
  }

  WriterLease lease_;
  simulator::AttemptChannels& channels_;
  FullDisk full_disk_;
  std::atomic<bool> is_stopping_{false};  ///< the recorder goes away: nothing is waited for
  WindowWriter pen_;
  WindowRows waiting_;
  std::int64_t next_window_ = 0;
  std::int64_t newest_tick_ = 0;
  std::int64_t duration_ticks_ = 0;
  std::int64_t covered_until_ = 0;  ///< the tick after the last that the tape covers
  std::int64_t gaps_ = 0, duplicates_ = 0;
  double cpu_s_ = 0.0;
  std::exception_ptr failure_;
  std::jthread thread_;  ///< last: started when all above is ready, joined before any of it goes
};

Recorder::Recorder(const Database& database, WriterLease lease,
                   simulator::AttemptChannels& channels, FullDisk full_disk)
    : writer_(
          std::make_unique<Writer>(database.open_again(), std::move(lease), channels, full_disk)) {}

Recorder::~Recorder() = default;

const AttemptId& Recorder::attempt() const noexcept { return writer_->attempt(); }

RecorderStatistics Recorder::drain() { return writer_->drain(); }

RecorderStatistics Recorder::finish(const std::string& quality_json) {
  const RecorderStatistics statistics = writer_->drain();
  writer_->seal(quality_json);
  return statistics;
}

RecorderStatistics Recorder::abandon() {
  const RecorderStatistics statistics = writer_->drain();
  writer_->abandon();
  return statistics;
}

}  // namespace hallux::database
