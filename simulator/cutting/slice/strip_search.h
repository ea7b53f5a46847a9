/// The edges and facing triangles of a contact's strip in square cells of the plane: what a
/// region's edge may cross, and what a region's corner may lie in, is found among its neighbours.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "simulator/cutting/slice/slab_slice.h"

namespace hallux::simulator {

class StripSearch {
 public:
  explicit StripSearch(const SlabSlice& contact);

  /// Calls visit(edge) at least once for every strip edge that the straight line from r to s meets.
  template <typename Visit>
  void edges_near(const LatticePoint& r, const LatticePoint& s, Visit&& visit) const {
    if (columns_ == 0) return;
    const Span columns = columns_between(r.u, s.u);
    for (std::int64_t column = columns.first; column <= columns.last; ++column) {
      const Span rows = rows_in_column(r, s, column);
      for (std::int64_t row = rows.first; row <= rows.last; ++row) {
        for (const std::uint32_t edge : edges_.in_cell(cell_at(column, row))) visit(edge);
      }
    }
  }
  /// The strip triangles, upright ones left out, that may hold the place.
  std::span<const std::uint32_t> triangles_near(const LatticePoint& place) const noexcept;

 private:
  struct Span {
    std::int64_t first = 0, last = -1;
  };
  struct Lists {
    std::vector<std::uint32_t> first, items;

    std::span<const std::uint32_t> in_cell(std::size_t cell) const noexcept {
      return {items.data() + first[cell], items.data() + first[cell + 1]};
    }
  };
  struct Cell {
    std::uint32_t column = 0, row = 0;
  };
  /// First and last; unless told, of no cell.
  struct CellBox {
    std::pair<std::uint32_t, std::uint32_t> columns{1, 0}, rows{1, 0};
  };

  std::size_t cell_at(std::int64_t column, std::int64_t row) const noexcept {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  Span columns_between(std::int64_t a, std::int64_t b) const noexcept;
  Span rows_in_column(const LatticePoint& r, const LatticePoint& s,
                      std::int64_t column) const noexcept;
  template <typename BoxOf>
  Lists sorted_into_cells(std::size_t count, BoxOf&& box_of) const;

  LatticePoint min_;
  std::int64_t cell_ = 1, columns_ = 0, rows_ = 0;
  Lists edges_, triangles_;
};

}  // namespace hallux::simulator
