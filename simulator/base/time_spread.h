/// Percentiles of as many times as come, in memory of a fixed size. Inside this room only.
///
/// Times are counted in classes: up to half a microsecond of one nanosecond each, beyond that 256
/// of the same width for each doubling. So a percentile is off by at most a five-hundredth.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "simulator/base/fixed_array.h"

namespace hallux {

class TimeSpread {
 public:
  /// Takes all its memory here.
  TimeSpread();

  /// A time below zero counts as none.
  void add(std::chrono::nanoseconds time) noexcept;
  /// The time that no more than this share of all lie above; 0 where none came.
  /// share   [0, 1]
  double at_us(double share) const noexcept;
  /// Exactly.
  double greatest_us() const noexcept;

 private:
  FixedArray<std::uint32_t> counts_;
  std::uint64_t count_ = 0;
  std::uint64_t greatest_ns_ = 0;
};

}  // namespace hallux
