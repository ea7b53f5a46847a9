/// Fills loops in a plane with triangles in one sweep along u (Hertel and Mehlhorn, "Fast
/// triangulation of simple polygons", 1983). Inside this corner only.
///
/// What lies left of the sweep is filled up to a chain of corners; every gap between two edges that
/// the sweep crosses has one:
///
///     upper edge  o------
///                 |\         The chain runs from the lower to the upper edge and bends away
///                 | \        from the gap: no corner of it sees past its neighbours. The
///                 |  o       next corner on either edge cuts off all that it sees; a corner
///                 | /        inside the gap is joined to the chain's latest one and parts
///                 |/         the gap.
///     lower edge  o-----
///
/// A corner asks its neighbours in the chain and nobody else, so that a loop costs little more than
/// sorting its corners.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "simulator/cutting/slice/nesting.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

class SweepTriangulator {
 public:
  /// Forgets all loops and keeps its memory; `points` is borrowed until they are filled.
  void begin(std::span<const LatticePoint> points);
  /// A loop of these points, inside on the left; fewer than three are none.
  void add_loop(std::span<const std::uint32_t> loop);
  /// A loop of all points in their order.
  void add_loop_of_all();

  /// Appends triangles over `points`.
  /// ensures each loop edge is used once, every other edge as often in one direction as in the
  ///         other; no triangle turns right
  /// errors  false where that cannot be (loops that cross or touch themselves) or a corner's edges
  ///         lie on each other: `triangles` is as it was
  /// thread  any; allocates nothing once it has seen as many corners
  bool fill(std::vector<Triangle>& triangles);

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Corner {
    std::uint32_t point = 0;
    std::uint32_t before = 0, behind = 0;
    /// Beside the edge from here to `behind`, while the sweep crosses it.
    std::uint32_t gap = none;
  };
  /// A corner's place in a chain.
  struct Link {
    std::uint32_t corner = 0;
    std::uint32_t below = none, above = none;
  };
  /// Edges are named by the corner that they leave: the lower one runs with the sweep, the upper
  /// one against it.
  struct Gap {
    std::uint32_t lower_edge = none, upper_edge = none;
    /// Links.
    std::uint32_t lowest = none, highest = none, latest = none;
    bool is_open = true;
  };

  const LatticePoint& at(std::uint32_t corner) const noexcept {
    return points_[corners_[corner].point];
  }
  bool is_earlier(std::uint32_t a, std::uint32_t b) const noexcept;
  void add_corner(std::uint32_t point, std::size_t i, std::size_t count);
  bool pass(std::uint32_t corner);
  bool begin_or_part(std::uint32_t corner);
  bool end_or_join(std::uint32_t corner);
  bool go_on_below(std::uint32_t corner);
  bool go_on_above(std::uint32_t corner);
  void begin_gap(std::uint32_t corner);
  void part_gap(std::uint32_t corner, std::uint32_t gap);
  void join_gaps(std::uint32_t corner, std::uint32_t lower, std::uint32_t upper);
  bool end_gap(std::uint32_t corner, std::uint32_t gap);

  std::uint32_t gap_around(std::uint32_t corner) const noexcept;
  void set_edges(std::uint32_t gap, std::uint32_t lower_edge, std::uint32_t upper_edge);
  std::uint32_t add_link(std::uint32_t corner, std::uint32_t below, std::uint32_t above);
  std::uint32_t cut_off_below(std::uint32_t corner, std::uint32_t link);
  std::uint32_t cut_off_above(std::uint32_t corner, std::uint32_t link);
  std::int64_t turn_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept {
    return turn(at(a), at(b), at(c));
  }
  void push(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  std::span<const LatticePoint> points_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> order_;
  std::vector<Link> links_;
  std::vector<Gap> gaps_;
  std::vector<Triangle> made_;
};

}  // namespace hallux::simulator
