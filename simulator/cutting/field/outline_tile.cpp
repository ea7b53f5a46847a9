// A cell's corners are named bl, br, tr, tl (u grows to the right, v upwards). A loop enters a cell
// where, looking inwards, the open node is on the left: at the bottom between bl open and br
// closed, at the right between br and tr, and so on around. It leaves where it is the other way
// round. In a cell with two open corners that face each other each segment cuts off one of them.
#include "simulator/cutting/field/outline_tile.h"

#include <algorithm>
#include <bit>

namespace hallux::simulator {

namespace {

/// Loops pass nodes at this share of the spacing at least, so that four crossings around a node
/// stay apart.
constexpr double least_share = 0.001;
/// Corners lie on this level of the field, so that the rounding of its floats (2e-9 mm) leaves the
/// crossings of a straight side within what a straight segment may pass.
constexpr double corner_level_mm = 1.0e-8;

constexpr unsigned bl = 1, br = 2, tr = 4, tl = 8;

struct NodeStep {
  std::int32_t i, j;
};

/// Per side where a loop enters: the open node, and the step to the closed one.
constexpr std::array<NodeStep, 4> open_node{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
constexpr std::array<NodeStep, 4> to_closed{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
/// Per side where a loop leaves: the step to the next cell.
constexpr std::array<NodeStep, 4> next_cell{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

constexpr std::size_t index_of(CellSide side) noexcept { return static_cast<std::size_t>(side); }

constexpr bool is_ambiguous(unsigned corners) noexcept {
  return corners == (bl | tr) || corners == (br | tl);
}

constexpr CellSide exit_of(unsigned corners, CellSide entry) noexcept {
  if (corners == (bl | tr)) return entry == CellSide::Bottom ? CellSide::Left : CellSide::Right;
  if (corners == (br | tl)) return entry == CellSide::Right ? CellSide::Bottom : CellSide::Top;
  if ((corners & (bl | br)) == br) return CellSide::Bottom;
  if ((corners & (br | tr)) == tr) return CellSide::Right;
  if ((corners & (tr | tl)) == tl) return CellSide::Top;
  return CellSide::Left;
}

constexpr CellSide first_entry(unsigned corners) noexcept {
  if ((corners & (bl | br)) == bl) return CellSide::Bottom;
  if ((corners & (br | tr)) == br) return CellSide::Right;
  if ((corners & (tr | tl)) == tr) return CellSide::Top;
  return CellSide::Left;
}

using ExitTable = std::array<std::array<CellSide, 4>, 16>;

constexpr ExitTable all_exits() noexcept {
  ExitTable exits{};
  for (unsigned corners = 0; corners < 16; ++corners) {
    for (unsigned side = 0; side < 4; ++side) {
      exits[corners][side] = exit_of(corners, static_cast<CellSide>(side));
    }
  }
  return exits;
}

constexpr ExitTable exits = all_exits();

/// A direction that no straight side is square to by habit: its furthest corner begins the loop.
double along_mm(const Vec2& point_mm) noexcept { return point_mm.x + 0.381966 * point_mm.y; }

}  // namespace

void OutlineTile::contour(const KerfField& field, std::int32_t column, std::int32_t row) {
  clear();
  u_first_ = column * cells - 1;
  v_first_ = row * cells - 1;
  if (!read_bits(field)) return;
  trace_from_sides(field);
  trace_rest(field);
}

/// False where all nodes are of one kind.
bool OutlineTile::read_bits(const KerfField& field) noexcept {
  constexpr std::uint64_t all_nodes = (std::uint64_t{1} << (cells + 1)) - 1;
  constexpr std::uint64_t all_cells = (std::uint64_t{1} << cells) - 1;
  std::uint64_t any = 0, all = all_nodes;
  for (std::int32_t i = 0; i <= cells; ++i) {
    const std::uint64_t line = field.open_nodes().from(u_first_ + i, v_first_) & all_nodes;
    open_[static_cast<std::size_t>(i)] = line;
    any |= line;
    all &= line;
  }
  if (any == 0 || all == all_nodes) return false;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const std::uint64_t left = open_[i], right = open_[i + 1];
    const std::uint64_t along = left ^ (left >> 1), across = left ^ right;
    segments_[i] = (along | across | (right ^ (right >> 1))) & all_cells;
    seconds_[i] = along & across & (right ^ (right >> 1)) & all_cells;
  }
  return true;
}

unsigned OutlineTile::corners(std::int32_t i, std::int32_t j) const noexcept {
  const std::uint64_t left = open_[static_cast<std::size_t>(i)] >> j;
  const std::uint64_t right = open_[static_cast<std::size_t>(i) + 1] >> j;
  return static_cast<unsigned>((left & 1) | (right & 1) << 1 | (right & 2) << 1 | (left & 2) << 2);
}

void OutlineTile::trace_from_sides(const KerfField& field) {
  constexpr std::int32_t end = cells - 1;
  for (std::int32_t i = 0; i < cells; ++i) {
    const std::uint64_t left = open_[static_cast<std::size_t>(i)];
    const std::uint64_t right = open_[static_cast<std::size_t>(i) + 1];
    if ((left & ~right & 1) != 0) trace(field, i, 0, CellSide::Bottom);
    if ((right & ~left) >> cells != 0) trace(field, i, end, CellSide::Top);
  }
  for (std::uint64_t in = (open_[0] >> 1) & ~open_[0] & ((std::uint64_t{1} << cells) - 1); in != 0;
       in &= in - 1) {
    trace(field, 0, std::countr_zero(in), CellSide::Left);
  }
  const std::uint64_t last = open_[cells];
  for (std::uint64_t in = last & ~(last >> 1) & ((std::uint64_t{1} << cells) - 1); in != 0;
       in &= in - 1) {
    trace(field, end, std::countr_zero(in), CellSide::Right);
  }
}

/// What enters from no side are loops within the tile.
void OutlineTile::trace_rest(const KerfField& field) {
  for (std::int32_t i = 0; i < cells; ++i) {
    std::uint64_t& segments = segments_[static_cast<std::size_t>(i)];
    std::uint64_t& seconds = seconds_[static_cast<std::size_t>(i)];
    while (segments != 0) {
      const std::int32_t j = std::countr_zero(segments);
      trace(field, i, j, first_entry(corners(i, j)));
    }
    while (seconds != 0) {
      const std::int32_t j = std::countr_zero(seconds);
      trace(field, i, j, opposite(first_entry(corners(i, j))));
    }
  }
}

/// False where the segment was traced before.
bool OutlineTile::take_segment(std::int32_t i, std::int32_t j, CellSide entry) noexcept {
  const bool is_second =
      (entry == CellSide::Top || entry == CellSide::Left) && is_ambiguous(corners(i, j));
  std::uint64_t& line =
      is_second ? seconds_[static_cast<std::size_t>(i)] : segments_[static_cast<std::size_t>(i)];
  const std::uint64_t bit = std::uint64_t{1} << j;
  if ((line & bit) == 0) return false;
  line &= ~bit;
  return true;
}

void OutlineTile::trace(const KerfField& field, std::int32_t i, std::int32_t j, CellSide entry) {
  const auto place_on = [](CellSide side, std::int32_t cell_i, std::int32_t cell_j) {
    return side == CellSide::Bottom || side == CellSide::Top ? cell_i : cell_j;
  };
  OutlineChain chain;
  chain.first = static_cast<std::uint32_t>(crossings_.size());
  chain.entry = {entry, place_on(entry, i, j)};
  for (;;) {
    if (!take_segment(i, j, entry)) {
      chain.is_closed = true;
      break;
    }
    crossings_.push_back(crossing(field, i, j, entry));
    const double here_mm = along_mm(crossings_.back().at_mm);
    if (crossings_.size() == chain.first + 1 || here_mm > chain.along_mm) {
      chain.along_mm = here_mm;
      chain.furthest = static_cast<std::uint32_t>(crossings_.size() - 1);
    }
    const CellSide exit = exits[corners(i, j)][index_of(entry)];
    const NodeStep step = next_cell[index_of(exit)];
    chain.exit = {exit, place_on(exit, i, j)};
    i += step.i;
    j += step.j;
    entry = opposite(exit);
    if (i < 0 || j < 0 || i >= cells || j >= cells) break;
  }
  chain.last = static_cast<std::uint32_t>(crossings_.size());
  chains_.push_back(chain);
}

Crossing OutlineTile::crossing(const KerfField& field, std::int32_t i, std::int32_t j,
                               CellSide entry) const noexcept {
  const FieldGrid& grid = field.grid();
  const NodeStep open = open_node[index_of(entry)], step = to_closed[index_of(entry)];
  const std::int32_t u = u_first_ + i + open.i, v = v_first_ + j + open.j;
  const std::int32_t u_closed = u + step.i, v_closed = v + step.j;
  const bool is_beyond =
      u_closed < 0 || v_closed < 0 || u_closed >= grid.u_count || v_closed >= grid.v_count;
  const double open_mm = static_cast<double>(field.at(u, v));
  const double closed_mm =
      is_beyond ? -grid.spacing_mm : static_cast<double>(field.at(u_closed, v_closed));
  const double per_mm = 1.0 / (open_mm - closed_mm);
  const auto share = [&](double level_mm) {
    return std::clamp((open_mm - level_mm) * per_mm, least_share, 1.0 - least_share);
  };
  const double at = share(corner_level_mm);
  const double inner = std::max(at - outline_slack_mm / grid.spacing_mm, least_share);
  const Vec2 node(u, v), way(step.i, step.j);
  const auto place = [&](double part) {
    return grid.origin_mm + grid.spacing_mm * (node + part * way);
  };
  return {place(at), place(share(0.0)), place(inner)};
}

}  // namespace hallux::simulator
