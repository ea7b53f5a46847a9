#include "simulator/cutting/slice/strip_search.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

StripSearch::StripSearch(const SlabSlice& contact) : min_(contact.min) {
  if (contact.points.empty()) return;
  // About two cells an edge: edges lie along curves, so most cells stay empty.
  const auto width = static_cast<double>(contact.max.u - contact.min.u + 1);
  const auto height = static_cast<double>(contact.max.v - contact.min.v + 1);
  const double cells = 2.0 * static_cast<double>(contact.edges.size());
  cell_ = static_cast<std::int64_t>(
              std::max(std::sqrt(width * height / cells), std::max(width, height) / cells)) +
          1;
  columns_ = (contact.max.u - contact.min.u) / cell_ + 1;
  rows_ = (contact.max.v - contact.min.v) / cell_ + 1;
  std::vector<Cell> cells_of_points;
  cells_of_points.reserve(contact.points.size());
  for (const StripPoint& point : contact.points) {
    cells_of_points.push_back({static_cast<std::uint32_t>((point.place.u - min_.u) / cell_),
                               static_cast<std::uint32_t>((point.place.v - min_.v) / cell_)});
  }
  const auto cell = [&](std::uint32_t point) { return cells_of_points[point]; };
  edges_ = sorted_into_cells(contact.edges.size(), [&](std::size_t i) {
    const Cell a = cell(contact.edges[i].a), b = cell(contact.edges[i].b);
    return CellBox{std::minmax(a.column, b.column), std::minmax(a.row, b.row)};
  });
  triangles_ = sorted_into_cells(contact.triangles.size(), [&](std::size_t i) {
    const StripTriangle& triangle = contact.triangles[i];
    if (triangle.facing == 0) return CellBox{};
    const Cell a = cell(triangle.points[0]), b = cell(triangle.points[1]),
               c = cell(triangle.points[2]);
    return CellBox{std::minmax({a.column, b.column, c.column}), std::minmax({a.row, b.row, c.row})};
  });
}

template <typename BoxOf>
StripSearch::Lists StripSearch::sorted_into_cells(std::size_t count, BoxOf&& box_of) const {
  const auto for_each_cell = [&](std::size_t item, auto&& visit) {
    const CellBox box = box_of(item);
    for (std::uint32_t row = box.rows.first; row <= box.rows.second; ++row) {
      for (std::uint32_t column = box.columns.first; column <= box.columns.second; ++column) {
        visit(cell_at(column, row));
      }
    }
  };
  Lists lists;
  lists.first.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  for (std::size_t item = 0; item < count; ++item) {
    for_each_cell(item, [&](std::size_t cell) { ++lists.first[cell]; });
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& first : lists.first) {
    sum += first;
    first = sum;
  }
  lists.items.resize(sum);
  for (std::size_t item = count; item-- > 0;) {
    for_each_cell(item, [&](std::size_t cell) {
      lists.items[--lists.first[cell]] = static_cast<std::uint32_t>(item);
    });
  }
  return lists;
}

StripSearch::Span StripSearch::columns_between(std::int64_t a, std::int64_t b) const noexcept {
  const std::int64_t low = std::min(a, b) - min_.u, high = std::max(a, b) - min_.u;
  if (high < 0 || low >= columns_ * cell_) return {};
  return {std::max<std::int64_t>(low, 0) / cell_, std::min(high / cell_, columns_ - 1)};
}

/// The rows that the line meets between the column's borders, one step more on either side for the
/// rounding.
StripSearch::Span StripSearch::rows_in_column(const LatticePoint& r, const LatticePoint& s,
                                              std::int64_t column) const noexcept {
  const LatticePoint& left = r.u < s.u ? r : s;
  const LatticePoint& right = r.u < s.u ? s : r;
  std::int64_t v_at_left = left.v, v_at_right = right.v;
  if (right.u > left.u) {
    const double slope =
        static_cast<double>(right.v - left.v) / static_cast<double>(right.u - left.u);
    const auto v_at = [&](std::int64_t u) {
      return left.v +
             static_cast<std::int64_t>(std::floor(slope * static_cast<double>(u - left.u)));
    };
    const std::int64_t from = min_.u + column * cell_;
    v_at_left = v_at(std::clamp(from, left.u, right.u));
    v_at_right = v_at(std::clamp(from + cell_, left.u, right.u));
  }
  const std::int64_t low = std::min(v_at_left, v_at_right) - 1 - min_.v;
  const std::int64_t high = std::max(v_at_left, v_at_right) + 2 - min_.v;
  if (high < 0 || low >= rows_ * cell_) return {};
  return {std::max<std::int64_t>(low, 0) / cell_, std::min(high / cell_, rows_ - 1)};
}

std::span<const std::uint32_t> StripSearch::triangles_near(
    const LatticePoint& place) const noexcept {
  const std::int64_t u = place.u - min_.u, v = place.v - min_.v;
  if (u < 0 || v < 0 || u >= columns_ * cell_ || v >= rows_ * cell_) return {};
  return triangles_.in_cell(cell_at(u / cell_, v / cell_));
}

}  // namespace hallux::simulator
