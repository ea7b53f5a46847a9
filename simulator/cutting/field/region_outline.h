/// The outline of what a kerf's blade has covered: closed loops in the kerf's plane.
/// Inside this room only.
///
/// Marching squares on the sign of the field: a loop crosses each grid edge between an open and a
/// closed node once, at the linear zero of the two values, and never nearer to a node than a
/// thousandth of the spacing. Of two open nodes that face each other over a cell's diagonal each
/// keeps its own corner: the bone between them stands. Nodes beyond the grid count as closed.
///
/// Corners are dropped where one straight segment crosses the same grid edges in the same order,
/// each crossing moved by at most `outline_slack_mm` towards its open node. So the simplified
/// outline is the outline of a field of the same signs: its loops are simple, do not touch, go
/// around the same nodes, and never enclose more than the field's own.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/base/vector.h"
#include "simulator/cutting/field/kerf.h"
#include "simulator/cutting/field/outline_tile.h"

namespace hallux::simulator {

/// Loops with the opened region on their left: outer ones counter-clockwise, holes clockwise; in
/// the kerf's plane.
struct RegionOutline {
  std::vector<Vec2> corners_mm;
  /// Loop i is corners [loop_ends[i - 1], loop_ends[i]).
  std::vector<std::uint32_t> loop_ends;
};

/// Its loops one by one.
std::vector<std::vector<Vec2>> loops_of(const RegionOutline& outline);

/// The outline of a field, from scratch.
/// shape   at least three corners a loop; loops in the order of the grid's tiles, each begins at a
///         corner that depends on the loop alone
RegionOutline outline_of(const KerfField& field);

/// Follows the outline of one field; contours only the tiles where the field changed since the last
/// call.
class OutlineTracker {
 public:
  explicit OutlineTracker(const FieldGrid& grid);

  /// Brings the outline up to date.
  /// needs   a field of this grid; at each call the same one
  /// ensures outline() equals outline_of(field) bit for bit, however the field came to be
  /// errors  none; allocates only where the outline is longer than any before and than about 200 mm
  void update(const KerfField& field);
  const RegionOutline& outline() const noexcept { return outline_; }

 private:
  struct ChainRef {
    std::size_t tile = 0, chain = 0;
  };

  void contour_tile(const KerfField& field, std::size_t tile);
  OutlineTile& drawn(std::size_t tile) noexcept {
    return drawn_[static_cast<std::size_t>(place_of_[tile])];
  }
  OutlineChain& chain_at(const ChainRef& at) noexcept { return drawn(at.tile).chains()[at.chain]; }
  void link_loops();
  void append_loop(ChainRef start);
  ChainRef next_of(const ChainRef& at) noexcept;
  void append_crossings(std::size_t tile, std::uint32_t first, std::uint32_t last);

  FieldGrid grid_;
  /// Per tile: the revision that was contoured.
  std::vector<std::uint32_t> seen_;
  /// Per tile: its place in drawn_; -1 where no loop passes.
  std::vector<std::int32_t> place_of_;
  std::vector<OutlineTile> drawn_;
  /// Places of drawn_ that no tile has.
  std::vector<std::int32_t> spare_;
  std::uint64_t linkings_ = 0;
  /// Of the loop at hand.
  std::vector<ChainRef> chains_;
  std::vector<Crossing> loop_;
  std::int32_t tile_rows_;
  RegionOutline outline_;
};

}  // namespace hallux::simulator
