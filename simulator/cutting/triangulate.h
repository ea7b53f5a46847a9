/// Fills loops in a plane with triangles, holes left open, so that the result closes whatever the loops look like.
///
/// Holes are joined to their outer loop by bridges; what results is clipped ear by ear. Reflex corners stand in a grid,
/// so that an ear is tested against near corners only. A ring of n corners always gives n - 2 triangles that use each
/// ring edge once: where no proper ear is left (corners that coincide or lie in line, loops that touch themselves) an
/// improper one is taken, of no area wherever possible. The signed area is right in every case.
#pragma once

#include <span>
#include <vector>

#include "simulator/cutting/nesting.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// Triangles over `points`, turning left inside loops that turn left.
/// needs   every loop has at least two corners; a loop of two gives no triangle
/// ensures each directed loop edge is used once, every other edge as often in one direction as in the other
std::vector<Triangle> triangulate(std::span<const LatticePoint> points,
                                  std::span<const Loop> loops);

}  // namespace hallux::simulator
