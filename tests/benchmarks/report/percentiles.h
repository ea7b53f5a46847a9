/// Times of repeated work, and what is said of them.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

namespace hallux::benchmarks {

/// Of a set of values in any unit.
struct Percentiles {
  std::size_t count = 0;
  /// Of the sample (n - 1).
  double mean = 0.0, deviation = 0.0;
  double least = 0.0, median = 0.0, p99 = 0.0, greatest = 0.0;
};

/// ensures all zero for no values; p99 is the smallest value that 99 percent do not exceed
Percentiles percentiles_of(std::vector<double> values);

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin_).count();
  }
  /// The processor time of this program since, all threads together: what would have passed on a
  /// machine with nothing else to do, where the work is done by one thread.
  double worked_milliseconds() const { return worked_ms() - begin_worked_ms_; }

 private:
  using Clock = std::chrono::steady_clock;
  static double worked_ms();

  Clock::time_point begin_ = Clock::now();
  double begin_worked_ms_ = worked_ms();
};

/// How often work is repeated: at least `least` and at most `most` times, no longer than about
/// `limit_s` beyond the least.
struct Repetitions {
  std::size_t least = 3, most = 9;
  double limit_s = 3.0;
};

/// The processor time of `work(made)`, where `made` is made anew by `make()` each time, outside the
/// clock.
template <typename Make, typename Work>
Percentiles time_ms(const Repetitions& repetitions, Make make, Work work) {
  std::vector<double> times_ms;
  const Stopwatch whole;
  while (
      times_ms.size() < repetitions.least ||
      (times_ms.size() < repetitions.most && whole.milliseconds() < 1000.0 * repetitions.limit_s)) {
    auto made = make();
    const Stopwatch watch;
    work(made);
    times_ms.push_back(watch.worked_milliseconds());
  }
  return percentiles_of(std::move(times_ms));
}

/// The processor time of a million square roots in a row, so that the figures of two machines can
/// be compared.
double calibration_ms();

}  // namespace hallux::benchmarks
