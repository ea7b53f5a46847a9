/// Ears are clipped where the sweep gave up: rings that touch or cross themselves. Rounds go from
/// strict to lenient: spikes without area first, then proper ears, at last any corner at all, so a
/// ring of n corners always ends in n - 2 triangles and the solid stays closed. Reflex corners wait
/// in a uniform grid: only they can lie in an ear.
#include "simulator/cutting/fill/triangulate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "simulator/cutting/fill/reflex_grid.h"

namespace hallux::simulator {

namespace {

struct Corner {
  std::uint32_t point = 0;
  std::uint32_t before = 0, behind = 0;  // corners of the ring
};

/// What rounding two corners may put between edges, or an edge and a corner, that touched.
constexpr std::int64_t rounding_steps = 2;

/// Which ears are taken: spikes before all others, and worse ones when no better one is left.
enum class Leniency { Spike, Proper, Tight, WithoutArea, Any };

Leniency worse(Leniency leniency) noexcept {
  return leniency == Leniency::Any ? Leniency::Any
                                   : static_cast<Leniency>(static_cast<int>(leniency) + 1);
}

constexpr std::uint32_t no_corner = std::numeric_limits<std::uint32_t>::max();

}  // namespace

/// One outer loop with its holes.
class Triangulator::Polygon {
 public:
  void reset(std::span<const LatticePoint> points) {
    points_ = points;
    corners_.clear();
  }

  /// The first ring is the outer one; returns a corner of the ring.
  std::uint32_t add_ring(std::span<const std::uint32_t> loop);
  /// The ring of all points in their order.
  std::uint32_t add_ring_of_all() {
    all_.resize(points_.size());
    std::iota(all_.begin(), all_.end(), 0U);
    return add_ring(all_);
  }
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
  bool is_ear(std::uint32_t corner, Leniency leniency) const noexcept;
  void list(std::uint32_t corner);
  void list_ring();
  std::uint32_t clip_one(std::uint32_t corner, std::vector<Triangle>& triangles);
  void clip(std::uint32_t corner, std::vector<Triangle>& triangles);
  void clip_round(Leniency leniency, std::vector<Triangle>& triangles);
  std::vector<std::uint32_t> ring_of(std::uint32_t start) const;
  void watch_reflex_corners(std::uint32_t start);

  std::span<const LatticePoint> points_;
  std::vector<std::uint32_t> all_;
  std::vector<Corner> corners_;
  ReflexGrid grid_;
  std::size_t left_ = 0;                           // corners in the ring that is clipped
  std::uint32_t in_ring_ = 0;                      // one of them
  std::vector<std::uint32_t> round_, next_round_;  // corners to try
  std::vector<std::uint8_t> is_listed_,
      is_clipped_;  // per corner: in next_round_; no longer in the ring
};

std::uint32_t Triangulator::Polygon::add_ring(std::span<const std::uint32_t> loop) {
  const auto first = static_cast<std::uint32_t>(corners_.size());
  const auto count = static_cast<std::uint32_t>(loop.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    corners_.push_back(
        {loop[i], first + (i > 0 ? i : count) - 1, first + (i + 1 < count ? i + 1 : 0)});
  }
  return first;
}

std::vector<std::uint32_t> Triangulator::Polygon::ring_of(std::uint32_t start) const {
  std::vector<std::uint32_t> ring{start};
  for (std::uint32_t i = corners_[start].behind; i != start; i = corners_[i].behind) {
    ring.push_back(i);
  }
  return ring;
}

/// O'Rourke's cone test (Computational Geometry in C, 1998, code 1.6): does the ring's inside begin
/// towards `target`?
bool Triangulator::Polygon::looks_inward(std::uint32_t corner,
                                         const LatticePoint& target) const noexcept {
  const LatticePoint& here = at(corner);
  const LatticePoint& before = at(corners_[corner].before);
  const LatticePoint& behind = at(corners_[corner].behind);
  if (turn(here, behind, before) >= 0) {
    return turn(here, target, before) > 0 && turn(target, here, behind) > 0;
  }
  return !(turn(here, target, behind) >= 0 && turn(target, here, before) >= 0);
}

namespace {

bool is_between(const LatticePoint& a, const LatticePoint& b, const LatticePoint& point) noexcept {
  return turn(a, b, point) == 0 && point != a && point != b && std::min(a.u, b.u) <= point.u &&
         point.u <= std::max(a.u, b.u) && std::min(a.v, b.v) <= point.v &&
         point.v <= std::max(a.v, b.v);
}

bool has_opposite_signs(std::int64_t a, std::int64_t b) noexcept {
  return (a > 0 && b < 0) || (a < 0 && b > 0);
}

}  // namespace

bool Triangulator::Polygon::is_visible(const LatticePoint& from,
                                       const LatticePoint& to) const noexcept {
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

/// The nearest corner of the outer ring that the hole's corner sees; the nearest of all where it
/// sees none.
std::uint32_t Triangulator::Polygon::find_bridge(std::uint32_t hole, std::uint32_t outer) const {
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

void Triangulator::Polygon::bridge(std::uint32_t outer, std::uint32_t hole) {
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

std::uint32_t Triangulator::Polygon::rightmost(std::uint32_t start) const noexcept {
  std::uint32_t best = start;
  for (std::uint32_t i = corners_[start].behind; i != start; i = corners_[i].behind) {
    if (std::pair(at(i).u, at(i).v) > std::pair(at(best).u, at(best).v)) best = i;
  }
  return best;
}

/// From right to left: then a hole's rightmost corner sees a corner of what is already one ring.
void Triangulator::Polygon::join_holes(std::vector<std::uint32_t> holes, std::uint32_t outer) {
  for (std::uint32_t& hole : holes) hole = rightmost(hole);
  std::sort(holes.begin(), holes.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(at(a).u, b) > std::pair(at(b).u, a);
  });
  for (const std::uint32_t hole : holes) bridge(find_bridge(hole, outer), hole);
}

namespace {

/// Whether the ring turns back on itself at `tip`: the shorter way there and the longer one back
/// lie no more than two steps apart, what rounding two corners may put between edges that were one
/// line. Clipped first, a spike takes no area with it; clipped around, it leaves two triangles that
/// cover each other, one of them the wrong way up.
bool is_spike(const LatticePoint& before, const LatticePoint& tip,
              const LatticePoint& behind) noexcept {
  const std::int64_t back_u = before.u - tip.u, back_v = before.v - tip.v;
  const std::int64_t on_u = behind.u - tip.u, on_v = behind.v - tip.v;
  if (back_u * on_u + back_v * on_v <= 0) return false;
  const std::int64_t longest =
      std::max({std::abs(back_u), std::abs(back_v), std::abs(on_u), std::abs(on_v)});
  return std::abs(back_u * on_v - back_v * on_u) <= rounding_steps * longest;
}

}  // namespace

bool Triangulator::Polygon::is_ear(std::uint32_t corner, Leniency leniency) const noexcept {
  if (leniency == Leniency::Any) return true;
  const LatticePoint& a = at(corners_[corner].before);
  const LatticePoint& b = at(corner);
  const LatticePoint& c = at(corners_[corner].behind);
  if (a == b || b == c) return true;
  if (is_spike(a, b, c)) return true;
  if (leniency == Leniency::Spike) return false;
  const std::int64_t area = turn(a, b, c);
  if (area == 0) return leniency == Leniency::WithoutArea;
  const std::int64_t slack = leniency == Leniency::Proper ? rounding_steps : 0;
  return area > 0 && !grid_.has_corner_in(a, b, c, slack);
}

void Triangulator::Polygon::watch_reflex_corners(std::uint32_t start) {
  grid_.reset(points_, corners_.size(), corners_.size());
  is_listed_.assign(corners_.size(), 0);
  is_clipped_.assign(corners_.size(), 0);
  left_ = 0;
  std::uint32_t corner = start;
  do {
    grid_.set_reflex(corner, at(corner), turn_at(corner) <= 0);
    ++left_;
    corner = corners_[corner].behind;
  } while (corner != start);
}

void Triangulator::Polygon::list(std::uint32_t corner) {
  if (is_listed_[corner] != 0) return;
  is_listed_[corner] = 1;
  next_round_.push_back(corner);
}

/// All corners of the ring, whatever they look like.
void Triangulator::Polygon::list_ring() {
  next_round_.clear();
  std::uint32_t corner = in_ring_;
  do {
    is_listed_[corner] = 1;
    next_round_.push_back(corner);
    corner = corners_[corner].behind;
  } while (corner != in_ring_);
}

/// Takes the corner out of the ring. Returns a neighbour that is a spike now, if there is one.
std::uint32_t Triangulator::Polygon::clip_one(std::uint32_t corner,
                                              std::vector<Triangle>& triangles) {
  const Corner tip = corners_[corner];
  triangles.push_back({corners_[tip.before].point, tip.point, corners_[tip.behind].point});
  corners_[tip.before].behind = tip.behind;
  corners_[tip.behind].before = tip.before;
  in_ring_ = tip.behind;
  is_clipped_[corner] = 1;
  --left_;
  grid_.set_reflex(corner, at(corner), false);
  std::uint32_t spike = no_corner;
  for (const std::uint32_t neighbour : {tip.before, tip.behind}) {
    const bool is_reflex = turn_at(neighbour) <= 0;
    grid_.set_reflex(neighbour, at(neighbour), is_reflex);
    if (!is_reflex) list(neighbour);
    if (spike == no_corner && is_ear(neighbour, Leniency::Spike)) spike = neighbour;
  }
  return spike;
}

void Triangulator::Polygon::clip(std::uint32_t corner, std::vector<Triangle>& triangles) {
  while (corner != no_corner && left_ >= 3) corner = clip_one(corner, triangles);
}

/// Tries each listed corner once. Behind an ear one corner waits for the next round, else fans of
/// slivers grow. Corners that turn right are not listed again until a neighbour is clipped.
void Triangulator::Polygon::clip_round(Leniency leniency, std::vector<Triangle>& triangles) {
  std::swap(round_, next_round_);
  next_round_.clear();
  std::uint32_t waiting = no_corner;
  for (const std::uint32_t corner : round_) {
    is_listed_[corner] = 0;
    if (is_clipped_[corner] != 0) continue;
    if (left_ < 3) return;
    if (corner != waiting && is_ear(corner, leniency)) {
      waiting = corners_[corner].behind;
      clip(corner, triangles);
      if (leniency > Leniency::Proper) return;
    } else if (corner == waiting || turn_at(corner) > 0) {
      list(corner);
    }
  }
}

void Triangulator::Polygon::clip_ears(std::uint32_t start, std::vector<Triangle>& triangles) {
  watch_reflex_corners(start);
  in_ring_ = start;
  list_ring();
  Leniency leniency = Leniency::Spike;
  while (left_ >= 3) {
    const std::size_t left_before = left_;
    clip_round(leniency, triangles);
    const bool has_clipped = left_ < left_before;
    if (has_clipped && leniency == Leniency::Proper) continue;
    leniency = has_clipped && leniency != Leniency::Spike ? Leniency::Proper : worse(leniency);
    if (left_ >= 3) list_ring();
  }
}

Triangulator::Triangulator() : polygon_(std::make_unique<Polygon>()) {}

Triangulator::~Triangulator() = default;

void Triangulator::fill_loop(std::span<const LatticePoint> points,
                             std::vector<Triangle>& triangles) {
  sweep_.begin(points);
  sweep_.add_loop_of_all();
  if (sweep_.fill(triangles)) return;
  polygon_->reset(points);
  polygon_->clip_ears(polygon_->add_ring_of_all(), triangles);
}

void Triangulator::fill_loops(std::span<const LatticePoint> points, std::span<const Loop> loops,
                              std::vector<Triangle>& triangles) {
  sweep_.begin(points);
  for (const Loop& loop : loops) sweep_.add_loop(loop);
  if (!sweep_.fill(triangles)) clip_loops(points, loops, triangles);
}

void Triangulator::clip_loops(std::span<const LatticePoint> points, std::span<const Loop> loops,
                              std::vector<Triangle>& triangles) {
  const std::vector<std::int32_t> around = loops_around(points, loops);
  std::vector<std::vector<std::size_t>> holes(loops.size());
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    if (around[loop] >= 0) holes[static_cast<std::size_t>(around[loop])].push_back(loop);
  }
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    if (around[loop] >= 0) continue;
    polygon_->reset(points);
    const std::uint32_t outer = polygon_->add_ring(loops[loop]);
    std::vector<std::uint32_t> inner;
    for (const std::size_t hole : holes[loop]) inner.push_back(polygon_->add_ring(loops[hole]));
    polygon_->join_holes(std::move(inner), outer);
    polygon_->clip_ears(outer, triangles);
  }
}

std::vector<Triangle> triangulate(std::span<const LatticePoint> points,
                                  std::span<const Loop> loops) {
  std::vector<Triangle> triangles;
  Triangulator().fill_loops(points, loops, triangles);
  return triangles;
}

}  // namespace hallux::simulator
