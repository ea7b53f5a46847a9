/// Loops in a plane on an integer lattice: exact orientation, containment and nesting.
///
/// The lattice decides questions only; positions that go into a mesh stay as they are. Its step is 2^-20 mm and the
/// loops lie within 64 mm of their middle, so that every determinant is exact in 64 bits; for larger sections the step
/// doubles until they fit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulator/base/vector.h"
#include "simulator/cutting/plane_slice.h"

namespace hallux::simulator {

struct LatticePoint {
  std::int64_t u = 0, v = 0;  ///< within +-2^26

  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

std::vector<LatticePoint> snap_to_lattice(std::span<const Vec2> places_mm);

/// Twice the signed area of a triangle: positive where a, b, c turn left. Exact.
constexpr std::int64_t turn(const LatticePoint& a, const LatticePoint& b,
                            const LatticePoint& c) noexcept {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}
/// Twice the signed area of a loop. Exact where the loop does not wind more than a hundred times.
std::int64_t doubled_area(std::span<const LatticePoint> points, const Loop& loop) noexcept;

/// For each loop that runs clockwise (a hole) the smallest counter-clockwise loop around it; -1 for the others.
std::vector<std::int32_t> loops_around(std::span<const LatticePoint> points,
                                       std::span<const Loop> loops);

}  // namespace hallux::simulator
