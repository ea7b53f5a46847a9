/// Loops on a lattice: areas, containment and nesting. Inside this room only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulator/base/vector.h"
#include "simulator/cutting/slice/plane_lattice.h"
#include "simulator/cutting/slice/plane_slice.h"

namespace hallux::simulator {

/// The places on a lattice of their own.
std::vector<LatticePoint> snap_to_lattice(std::span<const Vec2> places_mm);

/// Twice the signed area of a loop. Exact where the loop does not wind more than a hundred times.
std::int64_t doubled_area(std::span<const LatticePoint> points, const Loop& loop) noexcept;

/// For each loop that runs clockwise (a hole) the smallest counter-clockwise loop around it; -1 for
/// the others.
std::vector<std::int32_t> loops_around(std::span<const LatticePoint> points,
                                       std::span<const Loop> loops);

}  // namespace hallux::simulator
