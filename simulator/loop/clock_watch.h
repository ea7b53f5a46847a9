/// Whether the clock that paces the loop stood still or jumped against the machine's own time.
/// Inside this corner only.
///
/// The loop sleeps by the monotonic clock, which stops while a machine sleeps: afterwards no tick
/// is late, and yet the hand had time that no tick counts. The machine's time since it was started
/// goes on meanwhile. Both are slewed alike, and setting the wall clock moves neither.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace hallux::simulator {

/// The paced clock read just before and just after the machine's time.
struct ClockReading {
  std::chrono::nanoseconds paced_before{}, machine{}, paced_after{};
};

/// thread  any; takes no lock, allocates nothing
ClockReading read_clocks() noexcept;

class ClockWatch {
 public:
  /// Counts a step where the two moved apart by more than 10 ms since the reading before. A reading
  /// that took longer than a millisecond (the thread was put aside meanwhile) says nothing and is
  /// passed over.
  void observe(const ClockReading& reading) noexcept;
  std::int64_t steps() const noexcept { return steps_; }

 private:
  /// Machine's time less paced time, when seen last.
  std::optional<std::chrono::nanoseconds> apart_;
  std::int64_t steps_ = 0;
};

}  // namespace hallux::simulator
