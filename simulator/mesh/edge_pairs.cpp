#include "simulator/mesh/edge_pairs.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

/// A half-edge filed under the lower index of its two points.
struct FiledEdge {
  std::uint32_t other = 0;  ///< the higher index
  std::uint32_t half_edge = 0;
};

void note(EdgeFault& fault, std::uint32_t half_edge) noexcept {
  ++fault.count;
  fault.first = std::min(fault.first, half_edge);
}

/// Judges the half-edges between one pair of points.
void settle(const IndexedMesh& mesh, const FiledEdge* first, std::size_t count, EdgePairs& pairs) {
  const std::uint32_t lowest = first->half_edge;
  if (count == 1) return note(pairs.open, lowest);
  if (count > 2) return note(pairs.crowded, lowest);
  const std::uint32_t other = first[1].half_edge;
  if (origin_of(mesh, lowest) == origin_of(mesh, other)) return note(pairs.twisted, lowest);
  pairs.opposite[lowest] = other;
  pairs.opposite[other] = lowest;
}

}  // namespace

EdgePairs pair_edges(const IndexedMesh& mesh) {
  const auto half_edge_count = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  const auto lower_end = [&](std::uint32_t h) {
    return std::min(origin_of(mesh, h), origin_of(mesh, next_in_triangle(h)));
  };
  // Counting by the lower end instead of sorting all: linear in the size of the mesh.
  std::vector<std::uint32_t> start(mesh.points_mm.size() + 1, 0);
  for (std::uint32_t h = 0; h < half_edge_count; ++h) ++start[lower_end(h) + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<FiledEdge> filed(half_edge_count);
  std::vector<std::uint32_t> used = start;
  for (std::uint32_t h = 0; h < half_edge_count; ++h) {
    const std::uint32_t higher = std::max(origin_of(mesh, h), origin_of(mesh, next_in_triangle(h)));
    filed[used[lower_end(h)]++] = {higher, h};
  }

  EdgePairs pairs;
  pairs.opposite.assign(half_edge_count, no_half_edge);
  for (std::size_t point = 0; point + 1 < start.size(); ++point) {
    FiledEdge* const begin = filed.data() + start[point];
    FiledEdge* const end = filed.data() + start[point + 1];
    std::sort(begin, end, [](const FiledEdge& a, const FiledEdge& b) {
      return a.other != b.other ? a.other < b.other : a.half_edge < b.half_edge;
    });
    for (const FiledEdge* edge = begin; edge != end;) {
      const FiledEdge* last = edge;
      while (last != end && last->other == edge->other) ++last;
      settle(mesh, edge, static_cast<std::size_t>(last - edge), pairs);
      edge = last;
    }
  }
  return pairs;
}

}  // namespace hallux::simulator
