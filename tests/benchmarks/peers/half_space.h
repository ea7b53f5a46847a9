/// Half of space: how each peer is told where to cut.
#pragma once

#include <array>

#include "simulator/cutting/field/kerf.h"

namespace hallux::benchmarks {

/// The points p with normal . p <= offset; the normal has length 1.
struct HalfSpace {
  Vec3 normal{0.0, 0.0, 1.0};
  double offset_mm = 0.0;
};

/// What lies below and what lies above a kerf's plane at this height; the two touch.
std::array<HalfSpace, 2> sides_of(const simulator::KerfPlane& plane, double height_mm);
/// What lies below and above a kerf: between the two is the slab.
std::array<HalfSpace, 2> sides_of_slab(const simulator::KerfPlane& plane);

}  // namespace hallux::benchmarks
