/// A number that samples, tape or events give, with the moment that it is about.
/// Inside this room only.
#pragma once

#include <cstdint>

namespace hallux::assessment {

struct Finding {
  double value = 0.0;
  /// Both ends included.
  std::int64_t first_tick = 0, last_tick = 0;
  /// Of the value (see Measurement::bound), before it is rounded.
  double bound = 0.0;
};

}  // namespace hallux::assessment
