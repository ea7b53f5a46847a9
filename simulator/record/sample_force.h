/// The force of a sample in newtons.
#pragma once

#include "simulator/base/units.h"
#include "simulator/base/vector.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

/// On the hand, in the world [N]; exactly what was recorded.
inline Vec3 force_newton(const ToolSample& sample) noexcept {
  return {newton_from_millinewton(sample.force_mn[0]), newton_from_millinewton(sample.force_mn[1]),
          newton_from_millinewton(sample.force_mn[2])};
}

inline double force_size_newton(const ToolSample& sample) noexcept {
  return length_of(force_newton(sample));
}

}  // namespace hallux::simulator
