/// One motion of a blade in its plane, as the linear functions whose least is the stamp's value at
/// a node. Inside this corner only.
///
/// Picture: the hull of two rectangles, counter-clockwise. A hull edge that is a side of a
/// rectangle counts the distance to it. An edge that joins the two poses is the trace of a corner;
/// it counts the distance divided by |n . feed| + |n . side|, n its normal: for a straight motion
/// that is exactly the greatest, over all poses on the way, of the least distance to the two sides
/// at that corner. So the value is the same in one piece as in a thousand.
#pragma once

#include <array>
#include <cstdint>

#include "simulator/cutting/field/kerf.h"

namespace hallux::simulator {

class SweptBlade {
 public:
  /// needs   poses that are finite
  SweptBlade(const FieldGrid& grid, const Blade& blade, const PlanarPose& from,
             const PlanarPose& to, double limit_mm) noexcept;

  /// The lines that may hold values above -limit.
  const NodeSpan& lines() const noexcept { return lines_; }

  struct Line {
    /// All values above -limit.
    NodeSpan near;
    /// Within near, all values at least the limit; empty at near.last where there are none.
    NodeSpan deep;
    LineCover bounds;
    /// The edges that end `deep`.
    std::size_t rising_edge = 0, falling_edge = 0;
    /// Per edge: its value at v = 0 [mm].
    std::array<double, 8> at_line{};
  };
  Line line(std::int32_t u) const noexcept;

  /// Whether the cover shows that no node of the line can rise, bit for bit.
  bool is_covered(std::int32_t u, const LineCover& cover) const noexcept;
  bool is_low_covered(const Line& line, const LineCover& cover) const noexcept;
  bool is_high_covered(const Line& line, const LineCover& cover) const noexcept;

  double edge_mm(const Line& line, std::size_t edge, std::int32_t v) const noexcept {
    return along_v_[edge] * static_cast<double>(v) + line.at_line[edge];
  }
  /// The least over all edges.
  double inside_mm(const Line& line, std::int32_t v) const noexcept;

 private:
  void add_edge(const Vec2& a_mm, const Vec2& b_mm, const PlanarPose& pose,
                double spacing_mm) noexcept;
  void sort_edges() noexcept;
  void bound_sloped(Line& line) const noexcept;
  NodeSpan span(double first, double last) const noexcept;
  bool covers_low(std::size_t edge, double at_line_mm, const LineCover& cover) const noexcept;
  bool covers_high(std::size_t edge, double at_line_mm, const LineCover& cover) const noexcept;

  // Per edge, value = along_v * v + along_u * u + at_origin. Rising edges (along_v > 0) first, then
  // falling, then flat.
  std::array<double, 8> along_v_{}, along_u_{}, at_origin_{};
  /// 1 / along_v; 0 where flat.
  std::array<double, 8> nodes_per_mm_{};
  std::size_t rising_ = 0, sloped_ = 0, count_ = 0;
  double limit_mm_;
  std::int32_t v_count_;
  NodeSpan lines_;
};

}  // namespace hallux::simulator
