#include "simulator/cutting/pieces/edge_uses.h"

#include <algorithm>
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
  return edge_uses_from(0, triangles);
}

std::vector<EdgeUse> edge_uses_from(std::uint32_t first_triangle,
                                    std::span<const Triangle> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * (triangles.size() - first_triangle));
  for (std::uint32_t i = first_triangle; i < triangles.size(); ++i) {
    add_sides(triangles[i], i, uses);
  }
  sort_uses(uses);
  return uses;
}

std::vector<EdgeUse> edge_uses(std::span<const Triangle> triangles,
                               std::span<const std::uint32_t> chosen) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * chosen.size());
  for (const std::uint32_t i : chosen) add_sides(triangles[i], i, uses);
  sort_uses(uses);
  return uses;
}

DisjointSets sets_by_edges(std::span<const Triangle> triangles) {
  DisjointSets sets(triangles.size());
  const std::vector<EdgeUse> uses = edge_uses(triangles);
  for (std::size_t i = 1; i < uses.size(); ++i) {
    if (uses[i].edge == uses[i - 1].edge) sets.join(uses[i].triangle, uses[i - 1].triangle);
  }
  return sets;
}

}  // namespace hallux::simulator
