#include "simulator/cutting/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "simulator/cutting/reflex_grid.h"

namespace hallux::simulator {

namespace {

struct Corner {
  std::uint32_t point = 0;
  std::uint32_t before = 0, behind = 0;  // corners of the ring
};

/// How far an ear may fall short when no better one is left.
enum class Leniency { Proper, WithoutArea, Any };

/// One outer loop with its holes.
class Polygon {
 public:
  explicit Polygon(std::span<const LatticePoint> points) : points_(points) {}

  /// The first ring is the outer one; returns a corner of the ring.
  std::uint32_t add_ring(const Loop& loop);
  void join_holes(std::vector<std::uint32_t> holes, std::uint32_t outer);
  void clip_ears(std::uint32_t start, std::vector<Triangle>& triangles);

 private:
  const LatticePoint& at(std::uint32_t corner) const noexcept {
    return points_[corners_[corner].point];
  }
  std::int64_t turn_at(std::uint32_t corner) const noexcept {
    return turn(at(corners_[corner].before), at(corner), at(corners_[corner].behind));
  }
  bool looks_inward(std::uint32_t corner, const LatticePoint& target) const noexcept;
  bool is_visible(const LatticePoint& from, const LatticePoint& to) const noexcept;
  std::uint32_t find_bridge(std::uint32_t hole, std::uint32_t outer) const;
  void bridge(std::uint32_t outer, std::uint32_t hole);
  std::uint32_t rightmost(std::uint32_t start) const noexcept;
  bool is_ear(std::uint32_t corner, const ReflexGrid& grid, Leniency leniency) const noexcept;
  void update_reflex(std::uint32_t corner, ReflexGrid& grid) const;
  std::vector<std::uint32_t> ring_of(std::uint32_t start) const;

  std::span<const LatticePoint> points_;
  std::vector<Corner> corners_;
};

std::uint32_t Polygon::add_ring(const Loop& loop) {
  const auto first = static_cast<std::uint32_t>(corners_.size());
  const auto count = static_cast<std::uint32_t>(loop.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    corners_.push_back({loop[i], first + (i + count - 1) % count, first + (i + 1) % count});
  }
  return first;
}

std::vector<std::uint32_t> Polygon::ring_of(std::uint32_t start) const {
  std::vector<std::uint32_t> ring{start};
  for (std::uint32_t i = corners_[start].behind; i != start; i = corners_[i].behind) {
    ring.push_back(i);
  }
  return ring;
}

/// O'Rourke's cone test (Computational Geometry in C, 1998, code 1.6): does the ring's inside begin towards `target`?
bool Polygon::looks_inward(std::uint32_t corner, const LatticePoint& target) const noexcept {
  const LatticePoint& here = at(corner);
  const LatticePoint& before = at(corners_[corner].before);
  const LatticePoint& behind = at(corners_[corner].behind);
  if (turn(here, behind, before) >= 0) {
    return turn(here, target, before) > 0 && turn(target, here, behind) > 0;
  }
  return !(turn(here, target, behind) >= 0 && turn(target, here, before) >= 0);
}

bool is_between(const LatticePoint& a, const LatticePoint& b, const LatticePoint& point) noexcept {
  return turn(a, b, point) == 0 && point != a && point != b && std::min(a.u, b.u) <= point.u &&
         point.u <= std::max(a.u, b.u) && std::min(a.v, b.v) <= point.v &&
         point.v <= std::max(a.v, b.v);
}

bool has_opposite_signs(std::int64_t a, std::int64_t b) noexcept {
  return (a > 0 && b < 0) || (a < 0 && b > 0);
}

bool Polygon::is_visible(const LatticePoint& from, const LatticePoint& to) const noexcept {
  for (const Corner& corner : corners_) {
    const LatticePoint& a = points_[corner.point];
    const LatticePoint& b = at(corner.behind);
    if (is_between(from, to, a)) return false;
    if (has_opposite_signs(turn(from, to, a), turn(from, to, b)) &&
        has_opposite_signs(turn(a, b, from), turn(a, b, to))) {
      return false;
    }
  }
  return true;
}

/// The nearest corner of the outer ring that the hole's corner sees; the nearest of all where it sees none.
std::uint32_t Polygon::find_bridge(std::uint32_t hole, std::uint32_t outer) const {
  std::vector<std::uint32_t> ring = ring_of(outer);
  const LatticePoint& from = at(hole);
  const auto distance = [&](std::uint32_t corner) {
    const LatticePoint& to = at(corner);
    return (to.u - from.u) * (to.u - from.u) + (to.v - from.v) * (to.v - from.v);
  };
  std::sort(ring.begin(), ring.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(distance(a), a) < std::pair(distance(b), b);
  });
  for (const std::uint32_t corner : ring) {
    if (looks_inward(corner, from) && looks_inward(hole, at(corner)) &&
        is_visible(from, at(corner))) {
      return corner;
    }
  }
  return ring.front();
}

void Polygon::bridge(std::uint32_t outer, std::uint32_t hole) {
  const auto hole_again = static_cast<std::uint32_t>(corners_.size());
  const std::uint32_t outer_again = hole_again + 1;
  const Corner outer_corner = corners_[outer];
  const Corner hole_corner = corners_[hole];
  corners_.push_back({hole_corner.point, hole_corner.before, outer_again});
  corners_.push_back({outer_corner.point, hole_again, outer_corner.behind});
  corners_[hole_corner.before].behind = hole_again;
  corners_[outer_corner.behind].before = outer_again;
  corners_[outer].behind = hole;
  corners_[hole].before = outer;
}

std::uint32_t Polygon::rightmost(std::uint32_t start) const noexcept {
  std::uint32_t best = start;
  for (std::uint32_t i = corners_[start].behind; i != start; i = corners_[i].behind) {
    if (std::pair(at(i).u, at(i).v) > std::pair(at(best).u, at(best).v)) best = i;
  }
  return best;
}

/// From right to left: then a hole's rightmost corner sees a corner of what is already one ring.
void Polygon::join_holes(std::vector<std::uint32_t> holes, std::uint32_t outer) {
  for (std::uint32_t& hole : holes) hole = rightmost(hole);
  std::sort(holes.begin(), holes.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(at(a).u, b) > std::pair(at(b).u, a);
  });
  for (const std::uint32_t hole : holes) bridge(find_bridge(hole, outer), hole);
}

bool Polygon::is_ear(std::uint32_t corner, const ReflexGrid& grid,
                     Leniency leniency) const noexcept {
  if (leniency == Leniency::Any) return true;
  const LatticePoint& a = at(corners_[corner].before);
  const LatticePoint& b = at(corner);
  const LatticePoint& c = at(corners_[corner].behind);
  if (a == b || b == c) return true;
  const std::int64_t area = turn(a, b, c);
  if (area == 0) return leniency == Leniency::WithoutArea;
  return area > 0 && !grid.has_corner_in(a, b, c);
}

void Polygon::update_reflex(std::uint32_t corner, ReflexGrid& grid) const {
  grid.set_reflex(corner, at(corner), turn_at(corner) <= 0);
}

void Polygon::clip_ears(std::uint32_t start, std::vector<Triangle>& triangles) {
  const std::vector<std::uint32_t> ring = ring_of(start);
  if (ring.size() < 3) return;
  ReflexGrid grid(points_, corners_.size(), ring.size());
  for (const std::uint32_t corner : ring) update_reflex(corner, grid);
  std::size_t left = ring.size(), tried = 0;
  Leniency leniency = Leniency::Proper;
  std::uint32_t corner = start;
  while (left >= 3) {
    const Corner tip = corners_[corner];
    if (!is_ear(corner, grid, leniency)) {
      corner = tip.behind;
      if (++tried < left) continue;
      tried = 0;
      leniency = leniency == Leniency::Proper ? Leniency::WithoutArea : Leniency::Any;
      continue;
    }
    triangles.push_back({corners_[tip.before].point, tip.point, corners_[tip.behind].point});
    corners_[tip.before].behind = tip.behind;
    corners_[tip.behind].before = tip.before;
    grid.set_reflex(corner, at(corner), false);
    update_reflex(tip.before, grid);
    update_reflex(tip.behind, grid);
    --left;
    tried = 0;
    leniency = Leniency::Proper;
    corner = corners_[tip.behind].behind;  // one corner is skipped, else fans of slivers grow
  }
}

}  // namespace

std::vector<Triangle> triangulate(std::span<const LatticePoint> points,
                                  std::span<const Loop> loops) {
  const std::vector<std::int32_t> around = loops_around(points, loops);
  std::vector<std::vector<std::size_t>> holes(loops.size());
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    if (around[loop] >= 0) holes[static_cast<std::size_t>(around[loop])].push_back(loop);
  }
  std::vector<Triangle> triangles;
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    if (around[loop] >= 0) continue;
    Polygon polygon(points);
    const std::uint32_t outer = polygon.add_ring(loops[loop]);
    std::vector<std::uint32_t> inner;
    for (const std::size_t hole : holes[loop]) inner.push_back(polygon.add_ring(loops[hole]));
    polygon.join_holes(std::move(inner), outer);
    polygon.clip_ears(outer, triangles);
  }
  return triangles;
}

}  // namespace hallux::simulator
