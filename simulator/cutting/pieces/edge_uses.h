/// Which triangles share which edges, by sorting; and sets that are joined step by step.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// One side of a triangle.
struct EdgeUse {
  /// Lower point index in the high half, higher in the low half.
  std::uint64_t edge = 0;
  std::uint32_t triangle = 0;
  /// The triangle walks from the higher index to the lower.
  bool is_descending = false;
};

/// Sorted by edge, then triangle.
std::vector<EdgeUse> edge_uses(std::span<const Triangle> triangles);
/// The same from `first_triangle` on.
std::vector<EdgeUse> edge_uses_from(std::uint32_t first_triangle,
                                    std::span<const Triangle> triangles);
/// The same for some triangles of a mesh, named by their indices.
std::vector<EdgeUse> edge_uses(std::span<const Triangle> triangles,
                               std::span<const std::uint32_t> chosen);

/// Disjoint sets of 0 .. count-1; the root of a set is its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count);
  std::uint32_t root(std::uint32_t member) noexcept;
  void join(std::uint32_t a, std::uint32_t b) noexcept;

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace hallux::simulator
