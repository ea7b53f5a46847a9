/// How firmly the planned plane leads the hand in an attempt: chosen before it, kept with it, never
/// changed in it.
#pragma once

#include <cstdint>

namespace hallux::simulator {

enum class Guidance : std::int32_t {
  None = 0,
  /// A third of the slot's stiffness.
  Soft = 1,
  Slot = 2
};

}  // namespace hallux::simulator
