#include "simulator/cutting/slice/nesting.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

enum class Place { Outside, OnBorder, Inside };

struct LatticeBox {
  LatticePoint min, max;
};

LatticeBox box_of(std::span<const LatticePoint> points, const Loop& loop) noexcept {
  LatticeBox box{points[loop.front()], points[loop.front()]};
  for (const std::uint32_t index : loop) {
    const LatticePoint& point = points[index];
    box.min = {std::min(box.min.u, point.u), std::min(box.min.v, point.v)};
    box.max = {std::max(box.max.u, point.u), std::max(box.max.v, point.v)};
  }
  return box;
}

bool holds(const LatticeBox& outer, const LatticeBox& inner) noexcept {
  return outer.min.u <= inner.min.u && outer.min.v <= inner.min.v && outer.max.u >= inner.max.u &&
         outer.max.v >= inner.max.v;
}

Place place_in_loop(std::span<const LatticePoint> points, const Loop& loop,
                    const LatticePoint& wanted) noexcept {
  bool is_inside = false;
  for (std::size_t i = 0, last = loop.size() - 1; i < loop.size(); last = i++) {
    const LatticePoint& a = points[loop[last]];
    const LatticePoint& b = points[loop[i]];
    const std::int64_t side = turn(a, b, wanted);
    const bool is_in_box = std::min(a.u, b.u) <= wanted.u && wanted.u <= std::max(a.u, b.u) &&
                           std::min(a.v, b.v) <= wanted.v && wanted.v <= std::max(a.v, b.v);
    if (side == 0 && is_in_box) return Place::OnBorder;
    const bool is_crossed = (a.v > wanted.v) != (b.v > wanted.v);
    if (is_crossed && (side > 0) == (b.v > a.v)) is_inside = !is_inside;
  }
  return is_inside ? Place::Inside : Place::Outside;
}

/// Loops never cross, so the first corner that is not on the border decides; a loop wholly on the
/// border is inside.
bool is_within(std::span<const LatticePoint> points, const Loop& inner,
               const Loop& outer) noexcept {
  for (const std::uint32_t index : inner) {
    const Place place = place_in_loop(points, outer, points[index]);
    if (place != Place::OnBorder) return place == Place::Inside;
  }
  return true;
}

}  // namespace

std::vector<LatticePoint> snap_to_lattice(std::span<const Vec2> places_mm) {
  if (places_mm.empty()) return {};
  Vec2 min_mm = places_mm.front(), max_mm = places_mm.front();
  for (const Vec2& place_in_kerf_mm : places_mm) {
    min_mm = glm::min(min_mm, place_in_kerf_mm);
    max_mm = glm::max(max_mm, place_in_kerf_mm);
  }
  const PlaneLattice lattice(min_mm, max_mm);
  std::vector<LatticePoint> points;
  points.reserve(places_mm.size());
  for (const Vec2& place_in_kerf_mm : places_mm) points.push_back(lattice.snap(place_in_kerf_mm));
  return points;
}

std::int64_t doubled_area(std::span<const LatticePoint> points, const Loop& loop) noexcept {
  // The partial sums may wrap; unsigned arithmetic keeps the final sum, which fits, right.
  std::uint64_t sum = 0;
  for (std::size_t i = 0, last = loop.size() - 1; i < loop.size(); last = i++) {
    const LatticePoint& a = points[loop[last]];
    const LatticePoint& b = points[loop[i]];
    sum += static_cast<std::uint64_t>(a.u * b.v - a.v * b.u);
  }
  return static_cast<std::int64_t>(sum);
}

std::vector<std::int32_t> loops_around(std::span<const LatticePoint> points,
                                       std::span<const Loop> loops) {
  std::vector<std::int64_t> areas;
  std::vector<LatticeBox> boxes;
  for (const Loop& loop : loops) {
    areas.push_back(doubled_area(points, loop));
    boxes.push_back(box_of(points, loop));
  }
  std::vector<std::int32_t> around(loops.size(), -1);
  for (std::size_t hole = 0; hole < loops.size(); ++hole) {
    if (areas[hole] >= 0) continue;
    for (std::size_t outer = 0; outer < loops.size(); ++outer) {
      if (areas[outer] < -areas[hole] || !holds(boxes[outer], boxes[hole])) continue;
      const std::int32_t best = around[hole];
      if (best >= 0 && areas[static_cast<std::size_t>(best)] <= areas[outer]) continue;
      if (!is_within(points, loops[hole], loops[outer])) continue;
      around[hole] = static_cast<std::int32_t>(outer);
    }
  }
  return around;
}

}  // namespace hallux::simulator
