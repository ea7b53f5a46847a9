/// A stamp raises nodes to a value that depends on stamp and node alone, and the field keeps the
/// greatest: order, repetition and subdivision do not matter. Values end at a limit a few nodes
/// deep, so a line is a rim, a deep run that is filled at once, and a rim. Covers say which lines
/// cannot rise any more. Tiles of cells count revisions for whoever follows the outline.
#include "simulator/cutting/field/kerf.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "simulator/base/check.h"
#include "simulator/cutting/field/swept_blade.h"

namespace hallux::simulator {

namespace {

constexpr double limit_spacings = 1.0;

bool is_finite(const PlanarPose& pose) noexcept {
  return std::isfinite(pose.tip_mm.x) && std::isfinite(pose.tip_mm.y) &&
         std::isfinite(pose.direction.x) && std::isfinite(pose.direction.y);
}

void include(NodeSpan& span, std::int32_t v) noexcept {
  span = span.is_empty() ? NodeSpan{v, v + 1}
                         : NodeSpan{std::min(span.first, v), std::max(span.last, v + 1)};
}

/// Where the nodes from v on leave the tile, or end.
std::int32_t end_in_tile(std::int32_t v, std::int32_t last) noexcept {
  constexpr std::int32_t last_in_tile = KerfField::tile_cells - 1;
  return std::min(last, (v | last_in_tile) + 1);
}

void include(FieldWindow& window, std::int32_t u, const NodeSpan& span) noexcept {
  if (window.is_empty()) {
    window = {u, span.first, u + 1, span.last};
    return;
  }
  window.u_first = std::min(window.u_first, u);
  window.v_first = std::min(window.v_first, span.first);
  window.u_last = std::max(window.u_last, u + 1);
  window.v_last = std::max(window.v_last, span.last);
}

}  // namespace

PlanarPose planar_pose(const KerfPlane& plane, const RigidTransform& bone_from_tool) noexcept {
  const RigidTransform kerf_from_tool = inverse(plane.bone_from_kerf) * bone_from_tool;
  const Vec3 ahead = axis_x(kerf_from_tool);
  const Vec2 direction(ahead.x, ahead.y);
  PlanarPose pose;
  pose.tip_mm = Vec2(kerf_from_tool.translation_mm.x, kerf_from_tool.translation_mm.y);
  if (length_of(direction) > 0.0) pose.direction = unit(direction);
  return pose;
}

float KerfField::closed_mm(const FieldGrid& grid) noexcept {
  return -static_cast<float>(limit_spacings * grid.spacing_mm);
}

std::size_t KerfField::tiles_of(const FieldGrid& grid) noexcept {
  CHECK(grid.u_count > 0 && grid.v_count > 0);
  return static_cast<std::size_t>(tiles_over(grid.u_count)) *
         static_cast<std::size_t>(tiles_over(grid.v_count));
}

KerfField::KerfField(const FieldGrid& grid)
    : KerfField(grid, std::make_unique<TilePool>(tiles_of(grid), closed_mm(grid))) {}

KerfField::KerfField(const FieldGrid& grid, std::unique_ptr<TilePool> own) : KerfField(grid, *own) {
  own_pool_ = std::move(own);
}

KerfField::KerfField(const FieldGrid& grid, TilePool& pool)
    : grid_(grid),
      limit_mm_(-closed_mm(grid)),
      tile_rows_(tiles_over(grid.v_count)),
      pool_(&pool),
      tiles_(tiles_of(grid), pool.closed_tile()),
      deep_(grid.u_count, grid.v_count),
      open_(grid.u_count, grid.v_count),
      covers_(static_cast<std::size_t>(grid.u_count)),
      tile_revisions_(tiles_.size()) {
  CHECK(grid.spacing_mm > 0.0);
}

KerfField::KerfField(const KerfField& other) : KerfField(other.grid_) {
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
    if (other.tiles_[tile] == other.pool_->closed_tile()) continue;
    std::copy_n(other.tiles_[tile], TilePool::nodes_per_tile, writable_line(tile, 0));
  }
  deep_ = other.deep_;
  open_ = other.open_;
  covers_ = other.covers_;
  tile_revisions_ = other.tile_revisions_;
  revision_ = other.revision_;
}

bool KerfField::is_open(const Vec2& point_mm) const noexcept {
  const Vec2 node = (point_mm - grid_.origin_mm) / grid_.spacing_mm;
  const double u_floor = std::floor(node.x), v_floor = std::floor(node.y);
  if (!(u_floor >= 0.0 && v_floor >= 0.0 && u_floor + 1.0 < grid_.u_count &&
        v_floor + 1.0 < grid_.v_count)) {
    return false;
  }
  const auto u = static_cast<std::int32_t>(u_floor), v = static_cast<std::int32_t>(v_floor);
  const double part_u = node.x - u_floor, part_v = node.y - v_floor;
  const Corners corner = corners_from(u, v);
  const double lower = (1.0 - part_u) * static_cast<double>(corner.here) +
                       part_u * static_cast<double>(corner.next_u);
  const double upper = (1.0 - part_u) * static_cast<double>(corner.next_v) +
                       part_u * static_cast<double>(corner.next_both);
  return (1.0 - part_v) * lower + part_v * upper > 0.0;
}

/// The four nodes around a cell: but at a tile's end they lie in one.
KerfField::Corners KerfField::corners_from(std::int32_t u, std::int32_t v) const noexcept {
  constexpr std::int32_t last = tile_cells - 1;
  if (u % tile_cells == last || v % tile_cells == last) {
    return {at(u, v), at(u + 1, v), at(u, v + 1), at(u + 1, v + 1)};
  }
  const float* const here = line_in_tile(tile_of(u, v), u) + place_in_line(v);
  return {here[0], here[tile_cells], here[1], here[tile_cells + 1]};
}

void KerfField::put(const FieldWindow& window, std::span<const float> inside_mm) noexcept {
  ++revision_;
  FieldWindow all_changed;
  auto next = inside_mm.begin();
  for (std::int32_t u = window.u_first; u < window.u_last; ++u) {
    NodeSpan changed;
    for (std::int32_t v = window.v_first; v < window.v_last; ++v) {
      if (put_node(u, v, *next++)) include(changed, v);
    }
    if (changed.is_empty()) continue;
    note_risen(u, changed, all_changed);
    covers_[static_cast<std::size_t>(u)] = {LineCover{}, true};
  }
}

/// Whether the value was another one.
bool KerfField::put_node(std::int32_t u, std::int32_t v, float wanted_mm) noexcept {
  const float value_mm = wanted_mm > -limit_mm_ ? std::min(wanted_mm, limit_mm_) : -limit_mm_;
  if (at(u, v) == value_mm) return false;
  writable_line(tile_of(u, v), u)[place_in_line(v)] = value_mm;
  open_.put(u, v, value_mm > 0.0F);
  deep_.put(u, v, value_mm == limit_mm_);
  return true;
}

void KerfField::stamp(const Blade& blade, const PlanarPose& from, const PlanarPose& to,
                      FieldWindow& changed) noexcept {
  changed = {};
  if (!is_finite(from) || !is_finite(to)) return;
  ++revision_;
  const SweptBlade swept(grid_, blade, from, to, static_cast<double>(limit_mm_));
  for (std::int32_t u = swept.lines().first; u < swept.lines().last; ++u) {
    stamp_line(swept, u, changed);
  }
}

/// The part of a line at one end of a stamp.
struct KerfField::Rim {
  const SweptBlade& swept;
  const SweptBlade::Line& line;
  std::int32_t u;
  NodeSpan nodes;
  std::size_t likely_edge;  ///< holds the least value at most of the nodes
};

/// The value at a node is a function of stamp and node alone, never of what was stamped before;
/// which nodes are looked at depends on that, since nodes at the limit and nodes under a cover
/// cannot rise.
void KerfField::stamp_line(const SweptBlade& swept, std::int32_t u, FieldWindow& changed) noexcept {
  LineCover& cover = covers_[static_cast<std::size_t>(u)].known();
  if (swept.is_covered(u, cover)) return;
  const SweptBlade::Line line = swept.line(u);
  const auto note = [&](const NodeSpan& risen) {
    if (!risen.is_empty()) note_risen(u, risen, changed);
  };
  if (line.deep.is_empty()) {
    note(raise_rim({swept, line, u, line.near, line.rising_edge}));
    return;
  }
  const LineCover& bounds = line.bounds;
  if (!swept.is_low_covered(line, cover)) {
    note(raise_rim({swept, line, u, {line.near.first, line.deep.first}, line.rising_edge}));
    if (bounds.low_deep < cover.low_deep || bounds.low_deep > cover.low_end) {
      cover.low_near = bounds.low_near;
      cover.low_deep = bounds.low_deep;
      cover.low_end = bounds.low_end;
    }
  }
  if (!swept.is_high_covered(line, cover)) {
    note(raise_rim({swept, line, u, {line.deep.last, line.near.last}, line.falling_edge}));
    if (bounds.high_deep > cover.high_deep || bounds.high_deep < cover.high_end) {
      cover.high_near = bounds.high_near;
      cover.high_deep = bounds.high_deep;
      cover.high_end = bounds.high_end;
    }
  }
  note(fill_deep(u, line.deep));
}

/// The nodes that rose.
NodeSpan KerfField::raise_rim(const Rim& rim) noexcept {
  const float deep_mm = limit_mm_;
  const double limit_mm = static_cast<double>(deep_mm);
  NodeSpan risen;
  for (std::int32_t v = rim.nodes.first; v < rim.nodes.last;) {
    const std::size_t tile = tile_of(rim.u, v);
    float* line_mm = line_in_tile(tile, rim.u);
    bool is_writable = line_mm != closed_line(rim.u);
    for (const std::int32_t end = end_in_tile(v, rim.nodes.last); v < end; ++v) {
      // The least over all edges cannot rise above what is there where one edge cannot.
      const double likely_mm = std::min(rim.swept.edge_mm(rim.line, rim.likely_edge, v), limit_mm);
      const std::size_t place = place_in_line(v);
      if (static_cast<float>(likely_mm) <= line_mm[place]) continue;
      const auto value_mm =
          static_cast<float>(std::min(rim.swept.inside_mm(rim.line, v), limit_mm));
      if (value_mm <= line_mm[place]) continue;
      if (!std::exchange(is_writable, true)) line_mm = writable_line(tile, rim.u);
      line_mm[place] = value_mm;
      if (value_mm > 0.0F) open_.set(rim.u, v);
      if (value_mm == deep_mm) deep_.set(rim.u, v);
      include(risen, v);
    }
  }
  return risen;
}

/// Brings all nodes of the span to the limit; those that rose.
NodeSpan KerfField::fill_deep(std::int32_t u, const NodeSpan& deep) noexcept {
  NodeSpan risen;
  deep_.for_missing(u, deep.first, deep.last, [&](std::int32_t v, std::uint64_t missing) {
    const std::int32_t first = v + std::countr_zero(missing);
    const std::int32_t last = v + 64 - std::countl_zero(missing);
    fill(u, {first, last});
    include(risen, first);
    include(risen, last - 1);
  });
  if (risen.is_empty()) return risen;
  open_.set_span(u, risen.first, risen.last);
  deep_.set_span(u, risen.first, risen.last);
  return risen;
}

void KerfField::fill(std::int32_t u, const NodeSpan& nodes) noexcept {
  for (std::int32_t v = nodes.first; v < nodes.last;) {
    const std::int32_t end = end_in_tile(v, nodes.last);
    float* const line_mm = writable_line(tile_of(u, v), u);
    std::fill_n(line_mm + place_in_line(v), end - v, limit_mm_);
    v = end;
  }
}

/// Node u belongs to cells u and u + 1.
void KerfField::note_risen(std::int32_t u, const NodeSpan& risen, FieldWindow& changed) noexcept {
  include(changed, u, risen);
  for (std::int32_t column = u / tile_cells; column <= (u + 1) / tile_cells; ++column) {
    const std::int32_t start = column * tile_rows_;
    const std::int32_t first_tile = start + risen.first / tile_cells;
    const std::int32_t last_tile = start + risen.last / tile_cells;
    const auto first = static_cast<std::size_t>(first_tile);
    const auto last = static_cast<std::size_t>(last_tile);
    for (std::size_t tile = first; tile <= last; ++tile) tile_revisions_[tile] = revision_;
  }
}

}  // namespace hallux::simulator
