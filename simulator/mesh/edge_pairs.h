/// Which half-edge runs against which: the one question behind closedness, pseudonormals and fans.
///
/// Half-edge 3 t + k runs from corner k to corner k + 1 of triangle t.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

inline constexpr std::uint32_t no_half_edge = std::numeric_limits<std::uint32_t>::max();

/// How many edges have one fault, and a half-edge of the first of them.
struct EdgeFault {
  std::size_t count = 0;
  std::uint32_t first = no_half_edge;
};

struct EdgePairs {
  /// Per half-edge; no_half_edge where its edge is faulty.
  std::vector<std::uint32_t> opposite;
  /// Edges of one triangle only.
  EdgeFault open;
  /// Edges of three triangles or more.
  EdgeFault crowded;
  /// Edges that both triangles run along in the same direction.
  EdgeFault twisted;
};

/// needs   indices in range, no corner twice in a triangle, fewer than 2^32 / 3 triangles
EdgePairs pair_edges(const IndexedMesh& mesh);

inline std::uint32_t next_in_triangle(std::uint32_t half_edge) noexcept {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
inline std::uint32_t origin_of(const IndexedMesh& mesh, std::uint32_t half_edge) noexcept {
  return mesh.triangles[half_edge / 3][half_edge % 3];
}

}  // namespace hallux::simulator
