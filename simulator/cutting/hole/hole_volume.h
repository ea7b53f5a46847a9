/// The bone that holes take out of a solid, with a proven bound.
#pragma once

#include <span>

#include "simulator/cutting/hole/capsule.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

struct BoundedVolume {
  double volume_mm3 = 0.0;
  /// The true volume is no further than this from it.
  double bound_mm3 = 0.0;
};

/// The volume of the part of the solid that lies within any of the capsules; where they overlap it
/// is counted once.
/// shape   `solid`: closed; an inward-facing shell in it is a void
/// ensures the same capsules in the same order give the same bits; the bound falls to a quarter or
///         less as `rings` doubles, but where capsules overlap: there to a half
/// thread  any but haptic: fills vectors; a few milliseconds a capsule
/// source  docs/cutting.md section 9
BoundedVolume drilled_volume(const Bvh& solid, std::span<const Capsule> capsules, int rings = 32);

}  // namespace hallux::simulator
