/// The raw outline within one tile of a field's cells: marching squares along the chains, not over
/// the cells. Inside this corner only.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulator/cutting/field/kerf.h"

namespace hallux::simulator {

/// How far a straightened loop may move a crossing along its grid edge, towards the open node.
inline constexpr double outline_slack_mm = 2.0e-4;

/// Where a loop crosses a grid edge; `outer` to `inner` is where a straightened loop may cross it,
/// inner the nearer to the open node. All three lie on the edge.
struct Crossing {
  Vec2 at_mm, outer_mm, inner_mm;
};

enum class CellSide : std::uint8_t {
  Bottom,
  Right,
  Top,
  Left
};  // v falls, u grows, v grows, u falls

constexpr CellSide opposite(CellSide side) noexcept {
  return static_cast<CellSide>((static_cast<unsigned>(side) + 2) % 4);
}

/// Where a chain passes from one tile to the next: the edge's side of the tile that is entered or
/// left, and its place there.
struct TileGate {
  CellSide side = CellSide::Bottom;
  std::int32_t place = 0;

  bool operator==(const TileGate&) const = default;
};

/// A run of crossings with the opened region on its left, from the one that enters the tile to the
/// last before it leaves; the one that leaves is the next tile's first.
struct OutlineChain {
  /// Crossings [first, last) of the tile.
  std::uint32_t first = 0, last = 0;
  TileGate entry, exit;
  /// A loop within the tile.
  bool is_closed = false;
  /// The crossing with the greatest `along_mm`.
  std::uint32_t furthest = 0;
  /// In a direction of no meaning, the same for all.
  double along_mm = 0.0;
  /// For who follows the chains: the last time this one was met.
  std::uint64_t linked_in = 0;
};

class OutlineTile {
 public:
  /// Contours the cells of tile (column, row) anew.
  /// ensures chains in an order that depends on the field's values in these cells alone
  void contour(const KerfField& field, std::int32_t column, std::int32_t row);
  void clear() noexcept {
    crossings_.clear();
    chains_.clear();
  }
  void reserve(std::size_t crossings, std::size_t chains) {
    crossings_.reserve(crossings);
    chains_.reserve(chains);
  }

  std::vector<OutlineChain>& chains() noexcept { return chains_; }
  const std::vector<Crossing>& crossings() const noexcept { return crossings_; }

 private:
  static constexpr std::int32_t cells = KerfField::tile_cells;

  bool read_bits(const KerfField& field) noexcept;
  void trace_from_sides(const KerfField& field);
  void trace_rest(const KerfField& field);
  void trace(const KerfField& field, std::int32_t i, std::int32_t j, CellSide entry);
  bool take_segment(std::int32_t i, std::int32_t j, CellSide entry) noexcept;
  unsigned corners(std::int32_t i, std::int32_t j) const noexcept;
  Crossing crossing(const KerfField& field, std::int32_t i, std::int32_t j,
                    CellSide entry) const noexcept;

  std::vector<Crossing> crossings_;
  std::vector<OutlineChain> chains_;
  /// Node (0, 0) of the tile.
  std::int32_t u_first_ = 0, v_first_ = 0;
  /// Per line of nodes: open ones, bit j is node (i, j).
  std::array<std::uint64_t, cells + 1> open_{};
  /// Per line of cells: those with a segment that was not traced yet, and those with a second
  /// one.
  std::array<std::uint64_t, cells> segments_{}, seconds_{};
};

}  // namespace hallux::simulator
