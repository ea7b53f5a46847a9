/// Fills loops in a plane with triangles, holes left open, so that the result closes whatever the
/// loops look like. Inside this room only.
///
/// A sweep fills loops that are simple (sweep_triangulator.h). What touches or crosses itself is
/// filled ear by ear, its holes joined to their outer loop by bridges; reflex corners stand in a
/// grid, so that an ear is tested against near corners only. A ring of n corners always gives n - 2
/// triangles that use each ring edge once. Where the ring runs back on itself, to two lattice
/// steps, that spike is clipped before anything else, and a corner as near to an ear stands in its
/// way: clipped in another order, such rings (an edge of the region along an edge of the bone)
/// would leave triangles the wrong way up. Where no proper ear is left (loops that cross
/// themselves) an improper one is taken, of no area wherever possible. The signed area is right in
/// every case.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "simulator/cutting/fill/sweep_triangulator.h"
#include "simulator/cutting/slice/nesting.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// Triangles over `points`, turning left inside loops that turn left.
/// needs   every loop has at least two corners; a loop of two gives no triangle
/// ensures each directed loop edge is used once, every other edge as often in one direction as in
///         the other
std::vector<Triangle> triangulate(std::span<const LatticePoint> points,
                                  std::span<const Loop> loops);

/// The same, many times over, in memory that is kept.
class Triangulator {
 public:
  Triangulator();
  ~Triangulator();

  /// Appends the triangles of a single loop: all of its points, in order.
  /// needs   at least two points; allocates nothing once it has seen as large a loop
  void fill_loop(std::span<const LatticePoint> points, std::vector<Triangle>& triangles);
  /// Appends the triangles of several loops.
  void fill_loops(std::span<const LatticePoint> points, std::span<const Loop> loops,
                  std::vector<Triangle>& triangles);

 private:
  class Polygon;
  void clip_loops(std::span<const LatticePoint> points, std::span<const Loop> loops,
                  std::vector<Triangle>& triangles);

  SweepTriangulator sweep_;
  std::unique_ptr<Polygon> polygon_;
};

}  // namespace hallux::simulator
