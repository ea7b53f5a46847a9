#include "tests/benchmarks/peers/thesis_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/base/check.h"

namespace hallux::benchmarks {

namespace {

using simulator::Triangle;

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
}

/// Joins triangles across the edges that two of them name; edges named once stay as they are.
class EdgeJoiner {
 public:
  explicit EdgeJoiner(std::vector<std::array<std::uint32_t, 3>>& neighbours)
      : neighbours_(neighbours) {}

  void join(std::uint32_t triangle, std::uint32_t edge, std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] = open_.try_emplace(edge_key(a, b), std::pair{triangle, edge});
    if (is_new) return;
    const auto [other, other_edge] = place->second;
    neighbours_[triangle][edge] = other;
    neighbours_[other][other_edge] = triangle;
    open_.erase(place);
  }
  bool is_done() const { return open_.empty(); }

 private:
  std::vector<std::array<std::uint32_t, 3>>& neighbours_;
  std::unordered_map<std::uint64_t, std::pair<std::uint32_t, std::uint32_t>> open_;
};

}  // namespace

ThesisMesh::ThesisMesh(simulator::IndexedMesh mesh) : mesh_(std::move(mesh)) {
  const std::size_t count = mesh_.triangles.size();
  mesh_.points_mm.reserve(mesh_.points_mm.size() * 6 / 5 + 1024);
  mesh_.triangles.reserve(count * 6 / 5 + 1024);
  neighbours_.reserve(count * 6 / 5 + 1024);
  neighbours_.resize(count);
  EdgeJoiner joiner(neighbours_);
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    const Triangle& corners = mesh_.triangles[triangle];
    for (std::uint32_t i = 0; i < 3; ++i) {
      joiner.join(triangle, i, corners[i], corners[(i + 1) % 3]);
    }
  }
  CHECK(joiner.is_done());
  visited_.resize(count, 0);
}

bool ThesisMesh::is_above(std::uint32_t point) const {
  return glm::dot(normal_, mesh_.points_mm[point]) >= offset_mm_;
}

bool ThesisMesh::crosses(std::uint32_t triangle) const {
  const Triangle& corners = mesh_.triangles[triangle];
  const bool first = is_above(corners[0]);
  return is_above(corners[1]) != first || is_above(corners[2]) != first;
}

/// Thesis 4.5.4.
std::vector<std::uint32_t> ThesisMesh::walk_ring(std::uint32_t touched_triangle) {
  std::vector<std::uint32_t> ring, stack{touched_triangle};
  visited_[touched_triangle] = cut_;
  while (!stack.empty()) {
    const std::uint32_t triangle = stack.back();
    stack.pop_back();
    if (!crosses(triangle)) continue;
    ring.push_back(triangle);
    for (const std::uint32_t neighbour : neighbours_[triangle]) {
      if (visited_[neighbour] == cut_) continue;
      visited_[neighbour] = cut_;
      stack.push_back(neighbour);
    }
  }
  return ring;
}

std::uint32_t ThesisMesh::add_pair(const Vec3& point_mm) {
  const auto above = static_cast<std::uint32_t>(mesh_.points_mm.size());
  mesh_.points_mm.push_back(point_mm);
  mesh_.points_mm.push_back(point_mm);
  const Vec3 in_kerf_mm = transform_point(kerf_from_bone_, point_mm);
  pairs_.push_back({above, Vec2(in_kerf_mm.x, in_kerf_mm.y), false});
  return above;
}

std::uint32_t ThesisMesh::pair_on(std::uint32_t point_a, std::uint32_t point_b) {
  const std::uint64_t key = edge_key(point_a, point_b);
  const auto found = pair_on_edge_.find(key);
  if (found != pair_on_edge_.end()) return found->second;
  const Vec3 a_mm = mesh_.points_mm[point_a], b_mm = mesh_.points_mm[point_b];
  const double a = glm::dot(normal_, a_mm) - offset_mm_;
  const double b = glm::dot(normal_, b_mm) - offset_mm_;
  const std::uint32_t above = add_pair(a_mm + (a / (a - b)) * (b_mm - a_mm));
  pair_on_edge_.emplace(key, above);
  return above;
}

std::uint32_t ThesisMesh::add_triangle(const Triangle& corners) {
  const auto triangle = static_cast<std::uint32_t>(mesh_.triangles.size());
  mesh_.triangles.push_back(corners);
  neighbours_.push_back({});
  visited_.push_back(0);
  return triangle;
}

void ThesisMesh::pass_on_neighbour(std::uint32_t from, std::uint32_t edge, std::uint32_t to,
                                   std::uint32_t new_edge) {
  const std::uint32_t other = neighbours_[from][edge];
  neighbours_[to][new_edge] = other;
  std::replace(neighbours_[other].begin(), neighbours_[other].end(), from, to);
}

/// Thesis figure 4.7: the lone corner A stays with P and Q, the other two with a quadrilateral in
/// two triangles.
void ThesisMesh::split(std::uint32_t triangle, std::vector<std::uint32_t>& made) {
  const Triangle corners = mesh_.triangles[triangle];
  std::uint32_t lone = 0;
  const auto stands_alone = [&] {
    const bool side = is_above(corners[lone]);
    return is_above(corners[(lone + 1) % 3]) != side && is_above(corners[(lone + 2) % 3]) != side;
  };
  while (!stands_alone()) ++lone;
  const std::uint32_t a = corners[lone], b = corners[(lone + 1) % 3], c = corners[(lone + 2) % 3];
  const std::uint32_t p = pair_on(a, b), q = pair_on(c, a);
  const std::uint32_t a_side = is_above(a) ? 0 : 1, bc_side = 1 - a_side;

  const std::uint32_t base = add_triangle({b, c, p + bc_side});
  const std::uint32_t filling = add_triangle({c, q + bc_side, p + bc_side});
  pass_on_neighbour(triangle, (lone + 1) % 3, base, 0);
  mesh_.triangles[triangle] = {a, p + a_side, q + a_side};
  made.insert(made.end(), {triangle, base, filling});
  // Seen from above the plane, bone lies to the left.
  if (a_side == 0) {
    segments_.push_back({p, q});
  } else {
    segments_.push_back({q, p});
  }
}

/// Thesis 4.5.3: fans around the middle of a ring's corners, whatever the section looks like.
void ThesisMesh::add_caps(std::size_t first_pair, std::size_t first_segment) {
  Vec3 sum_mm(0.0);
  for (std::size_t i = first_pair; i < pairs_.size(); ++i) {
    sum_mm += mesh_.points_mm[pairs_[i].above];
  }
  const auto count = static_cast<double>(pairs_.size() - first_pair);
  const std::uint32_t middle = add_pair(sum_mm / count);
  for (std::size_t i = first_segment; i < segments_.size(); ++i) {
    const auto [from, to] = segments_[i];
    add_triangle({middle, to, from});
    add_triangle({middle + 1, from + 1, to + 1});
  }
}

void ThesisMesh::slice_ring(std::uint32_t touched_triangle, std::vector<std::uint32_t>& made) {
  const std::vector<std::uint32_t> ring = walk_ring(touched_triangle);
  const std::size_t first_pair = pairs_.size(), first_segment = segments_.size();
  for (const std::uint32_t triangle : ring) split(triangle, made);
  const auto first_cap = static_cast<std::uint32_t>(mesh_.triangles.size());
  add_caps(first_pair, first_segment);
  for (std::uint32_t i = first_cap; i < mesh_.triangles.size(); ++i) made.push_back(i);
}

/// Edges inside the split ring and the caps; the outer ones were passed on before.
void ThesisMesh::link(const std::vector<std::uint32_t>& made) {
  EdgeJoiner joiner(neighbours_);
  const auto is_original = [&](std::uint32_t point) { return point < pairs_.front().above; };
  for (const std::uint32_t triangle : made) {
    const Triangle& corners = mesh_.triangles[triangle];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t from = corners[i], to = corners[(i + 1) % 3];
      if (!is_original(from) || !is_original(to)) joiner.join(triangle, i, from, to);
    }
  }
  CHECK(joiner.is_done());
}

bool ThesisMesh::begin_cut(const simulator::KerfPlane& plane,
                           std::span<const std::uint32_t> touched) {
  plane_ = plane;
  normal_ = transform_direction(plane.bone_from_kerf, Vec3(0.0, 0.0, 1.0));
  offset_mm_ = glm::dot(normal_, plane.bone_from_kerf.translation_mm);
  kerf_from_bone_ = inverse(plane.bone_from_kerf);
  pairs_.clear();
  pair_on_edge_.clear();
  segments_.clear();
  parted_ = 0;
  ++cut_;
  std::vector<std::uint32_t> made;
  for (const std::uint32_t triangle : touched) {
    if (visited_[triangle] != cut_ && crosses(triangle)) slice_ring(triangle, made);
  }
  if (pairs_.empty()) return false;
  link(made);
  return true;
}

std::size_t ThesisMesh::advance(const simulator::Blade& blade, const simulator::PlanarPose& pose) {
  std::size_t moved = 0;
  for (Pair& pair : pairs_) {
    if (pair.is_parted) continue;
    const Vec2 from_tip_mm = pair.place_mm - pose.tip_mm;
    const double forward_mm = glm::dot(from_tip_mm, pose.direction);
    const double across_mm = pose.direction.x * from_tip_mm.y - pose.direction.y * from_tip_mm.x;
    if (forward_mm > 0.0 || forward_mm < -blade.depth_mm ||
        std::abs(across_mm) > 0.5 * blade.width_mm) {
      continue;
    }
    mesh_.points_mm[pair.above] += 0.5 * plane_.thickness_mm * normal_;
    mesh_.points_mm[pair.above + 1] -= 0.5 * plane_.thickness_mm * normal_;
    pair.is_parted = true;
    ++moved;
  }
  parted_ += moved;
  return moved;
}

/// Thesis 4.6.
std::size_t ThesisMesh::count_parts() const {
  std::vector<bool> is_visited(mesh_.triangles.size(), false);
  std::vector<std::uint32_t> stack;
  std::size_t parts = 0;
  for (std::uint32_t start = 0; start < mesh_.triangles.size(); ++start) {
    if (is_visited[start]) continue;
    ++parts;
    is_visited[start] = true;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::uint32_t triangle = stack.back();
      stack.pop_back();
      for (const std::uint32_t neighbour : neighbours_[triangle]) {
        if (is_visited[neighbour]) continue;
        is_visited[neighbour] = true;
        stack.push_back(neighbour);
      }
    }
  }
  return parts;
}

std::size_t ThesisMesh::folded_triangles() const {
  std::vector<Vec3> before_mm;
  for (const Pair& pair : pairs_) {
    const double back_mm = pair.is_parted ? 0.5 * plane_.thickness_mm : 0.0;
    before_mm.push_back(mesh_.points_mm[pair.above] - back_mm * normal_);
    before_mm.push_back(mesh_.points_mm[pair.above + 1] + back_mm * normal_);
  }
  std::size_t folded = 0;
  for (const Triangle& corners : mesh_.triangles) {
    std::array<Vec3, 3> now_mm{}, then_mm{};
    bool was_moved = false;
    for (std::size_t i = 0; i < 3; ++i) {
      now_mm[i] = then_mm[i] = mesh_.points_mm[corners[i]];
      if (pairs_.empty() || corners[i] < pairs_.front().above) continue;
      then_mm[i] = before_mm[corners[i] - pairs_.front().above];
      was_moved = true;
    }
    if (!was_moved) continue;
    const Vec3 now = glm::cross(now_mm[1] - now_mm[0], now_mm[2] - now_mm[0]);
    const Vec3 then = glm::cross(then_mm[1] - then_mm[0], then_mm[2] - then_mm[0]);
    if (glm::dot(now, then) < 0.0) ++folded;
  }
  return folded;
}

}  // namespace hallux::benchmarks
