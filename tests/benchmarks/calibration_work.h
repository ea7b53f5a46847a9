/// The fixed piece of work that every program of these benchmarks begins with.
#pragma once

#include <cmath>

namespace hallux::benchmarks {

/// A million square roots, each waiting for the last: about what a processor does one after another
/// in 4 to 8 ms.
inline double million_square_roots() noexcept {
  double value = 2.0;
  for (int i = 0; i < 1'000'000; ++i) value = std::sqrt(value + 1.0);
  return value;
}

}  // namespace hallux::benchmarks
