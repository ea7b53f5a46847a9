/// Which triangles share which edges, by sorting. Inside this room only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulator/base/disjoint_sets.h"
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

/// The triangles, joined where they share an edge: each set is a shell.
DisjointSets sets_by_edges(std::span<const Triangle> triangles);

}  // namespace hallux::simulator
