#include "simulator/cutting/fill/reflex_grid.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

void ReflexGrid::reset(std::span<const LatticePoint> points, std::size_t corner_count,
                       std::size_t corners_expected) {
  entries_.assign(corner_count, {});
  LatticePoint max = points.front();
  min_ = points.front();
  for (const LatticePoint& point : points) {
    min_ = {std::min(min_.u, point.u), std::min(min_.v, point.v)};
    max = {std::max(max.u, point.u), std::max(max.v, point.v)};
  }
  // About one corner a cell: the corners lie on curves, so a finer grid costs more than it saves.
  const double cells_wanted = std::sqrt(static_cast<double>(corners_expected)) + 1.0;
  const std::int64_t extent = std::max(max.u - min_.u, max.v - min_.v);
  cell_ = extent / static_cast<std::int64_t>(cells_wanted) + 1;
  columns_ = column_of(max.u) + 1;
  rows_ = row_of(max.v) + 1;
  first_in_cell_.assign(static_cast<std::size_t>(columns_ * rows_), -1);
}

void ReflexGrid::set_reflex(std::uint32_t corner, const LatticePoint& place, bool is_reflex) {
  Entry& entry = entries_[corner];
  entry.is_reflex = is_reflex;
  if (!is_reflex || entry.is_listed) return;
  const auto cell = static_cast<std::size_t>(row_of(place.v) * columns_ + column_of(place.u));
  entry = {place, first_in_cell_[cell], true, true};
  first_in_cell_[cell] = static_cast<std::int32_t>(corner);
}

bool ReflexGrid::has_corner_in(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                               std::int64_t slack) const noexcept {
  const LatticePoint min{std::min({a.u, b.u, c.u}) - slack, std::min({a.v, b.v, c.v}) - slack};
  const LatticePoint max{std::max({a.u, b.u, c.u}) + slack, std::max({a.v, b.v, c.v}) + slack};
  const std::int64_t least = -slack * std::max(max.u - min.u, max.v - min.v);
  const auto stands_in = [&](const Entry& entry) {
    const LatticePoint& p = entry.place;
    return entry.is_reflex && turn(a, b, p) >= least && turn(b, c, p) >= least &&
           turn(c, a, p) >= least && p != a && p != b && p != c;
  };
  const std::int64_t first_column = column_of(std::max(min.u, min_.u));
  const std::int64_t last_column = std::min(column_of(max.u), columns_ - 1);
  const std::int64_t last_row = std::min(row_of(max.v), rows_ - 1);
  for (std::int64_t row = row_of(std::max(min.v, min_.v)); row <= last_row; ++row) {
    for (std::int64_t column = first_column; column <= last_column; ++column) {
      std::int32_t at = first_in_cell_[static_cast<std::size_t>(row * columns_ + column)];
      for (; at >= 0; at = entries_[static_cast<std::size_t>(at)].next_in_cell) {
        if (stands_in(entries_[static_cast<std::size_t>(at)])) return true;
      }
    }
  }
  return false;
}

}  // namespace hallux::simulator
