/// The reflex corners of a polygon in square cells: what can stand in the way of an ear is found
/// among its neighbours. Inside this corner only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulator/cutting/slice/nesting.h"

namespace hallux::simulator {

class ReflexGrid {
 public:
  /// Forgets all corners; keeps its memory.
  /// needs   corner indices are below corner_count; `corners_expected` of them are in use; corners
  ///         lie among `points`
  void reset(std::span<const LatticePoint> points, std::size_t corner_count,
             std::size_t corners_expected);

  /// needs   a corner keeps its place
  void set_reflex(std::uint32_t corner, const LatticePoint& place, bool is_reflex);
  /// Whether a reflex corner lies in the closed triangle or at most about `slack` steps outside,
  /// corners at a, b or c not counted.
  bool has_corner_in(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                     std::int64_t slack) const noexcept;

 private:
  struct Entry {
    LatticePoint place;
    std::int32_t next_in_cell = -1;
    bool is_listed = false, is_reflex = false;
  };

  std::int64_t column_of(std::int64_t u) const noexcept { return (u - min_.u) / cell_; }
  std::int64_t row_of(std::int64_t v) const noexcept { return (v - min_.v) / cell_; }

  LatticePoint min_;
  std::int64_t cell_ = 1, columns_ = 1, rows_ = 1;
  std::vector<std::int32_t> first_in_cell_;
  std::vector<Entry> entries_;
};

}  // namespace hallux::simulator
