#include "simulator/cutting/pieces/edge_uses.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hallux::simulator {

namespace {

void add_sides(const Triangle& corners, std::uint32_t triangle, std::vector<EdgeUse>& uses) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
    const std::uint64_t edge = (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
    uses.push_back({edge, triangle, a > b});
  }
}

void sort_uses(std::vector<EdgeUse>& uses) {
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::pair(a.edge, a.triangle) < std::pair(b.edge, b.triangle);
  });
}

}  // namespace

std::vector<EdgeUse> edge_uses(std::span<const Triangle> triangles) {
  std::vector<EdgeUse> uses;
  edge_uses_from(0, triangles, uses);
  return uses;
}

void edge_uses_from(std::uint32_t first_triangle, std::span<const Triangle> triangles,
                    std::vector<EdgeUse>& uses) {
  uses.clear();
  uses.reserve(3 * (triangles.size() - first_triangle));
  for (std::uint32_t i = first_triangle; i < triangles.size(); ++i) {
    add_sides(triangles[i], i, uses);
  }
  sort_uses(uses);
}

std::vector<EdgeUse> edge_uses(std::span<const Triangle> triangles,
                               std::span<const std::uint32_t> chosen) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * chosen.size());
  for (const std::uint32_t i : chosen) add_sides(triangles[i], i, uses);
  sort_uses(uses);
  return uses;
}

DisjointSets::DisjointSets(std::size_t count) : parent_(count) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t DisjointSets::root(std::uint32_t member) noexcept {
  while (parent_[member] != member) {
    parent_[member] = parent_[parent_[member]];
    member = parent_[member];
  }
  return member;
}

void DisjointSets::join(std::uint32_t a, std::uint32_t b) noexcept {
  const std::uint32_t root_a = root(a), root_b = root(b);
  if (root_a < root_b) {
    parent_[root_b] = root_a;
  } else {
    parent_[root_a] = root_b;
  }
}

}  // namespace hallux::simulator
