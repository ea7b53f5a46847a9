#include "simulator/cutting/solid/mend_solid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "simulator/cutting/pieces/edge_uses.h"

namespace hallux::simulator {

namespace {

/// Splits two triangles that share an edge at the point in its middle.
void split_shared_edge(std::vector<Triangle>& triangles, std::vector<FaceSource>& sources,
                       const std::array<std::uint32_t, 2>& ends, std::uint32_t middle,
                       const std::array<std::uint32_t, 2>& shared_by) {
  for (const std::uint32_t index : shared_by) {
    Triangle corners = triangles[index];
    const auto is_edge_start = [&] {
      return (corners[0] == ends[0] && corners[1] == ends[1]) ||
             (corners[0] == ends[1] && corners[1] == ends[0]);
    };
    while (!is_edge_start()) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    triangles[index] = {corners[0], middle, corners[2]};
    triangles.push_back({middle, corners[1], corners[2]});
    sources.push_back(FaceSource{sources[index]});
  }
}

constexpr std::uint32_t no_point = std::numeric_limits<std::uint32_t>::max();

/// The corner of the triangle that is no end of the edge.
std::uint32_t apex_of(const std::vector<Triangle>& triangles, const EdgeUse& use) {
  const auto low = static_cast<std::uint32_t>(use.edge >> 32U);
  const auto high = static_cast<std::uint32_t>(use.edge & 0xffffffffU);
  const Triangle& corners = triangles[use.triangle];
  return *std::find_if(corners.begin(), corners.end(),
                       [&](std::uint32_t corner) { return corner != low && corner != high; });
}

/// The point in the middle of two points.
std::uint32_t add_middle(IndexedMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const Vec3 middle_mm = 0.5 * (mesh.points_mm[a] + mesh.points_mm[b]);
  mesh.points_mm.push_back(middle_mm);
  return static_cast<std::uint32_t>(mesh.points_mm.size() - 1);
}

/// One round; false where nothing was repeated.
bool separate_once(CutSolid& solid, std::uint32_t first_triangle) {
  std::vector<Triangle>& triangles = solid.mesh.triangles;
  const std::vector<EdgeUse> uses = edge_uses_from(first_triangle, triangles);
  std::vector<std::uint8_t> is_split_at(triangles.size() - first_triangle, 0);
  const auto is_split = [&](const EdgeUse& use) -> std::uint8_t& {
    return is_split_at[use.triangle - first_triangle];
  };
  bool found = false;
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].edge == uses[first].edge) ++last;
    if (last - first <= 2) continue;
    found = true;
    const auto usable = [&](bool is_descending, std::uint32_t shunned_apex) {
      std::size_t i = first;
      while (i < last && (uses[i].is_descending != is_descending || is_split(uses[i]) != 0 ||
                          apex_of(triangles, uses[i]) == shunned_apex)) {
        ++i;
      }
      return i;
    };
    // Two triangles over the same three points would share the halves' new edge too, and so on
    // without end.
    const std::size_t up = usable(false, no_point);
    if (up == last) continue;
    std::size_t down = usable(true, apex_of(triangles, uses[up]));
    if (down == last) down = usable(true, no_point);
    if (down == last) continue;
    is_split(uses[up]) = is_split(uses[down]) = 1;
    const std::array<std::uint32_t, 2> ends{
        static_cast<std::uint32_t>(uses[first].edge >> 32U),
        static_cast<std::uint32_t>(uses[first].edge & 0xffffffffU)};
    split_shared_edge(triangles, solid.sources, ends, add_middle(solid.mesh, ends[0], ends[1]),
                      {uses[up].triangle, uses[down].triangle});
  }
  return found;
}

}  // namespace

void separate_repeated_edges(CutSolid& solid, std::uint32_t first_triangle) {
  while (separate_once(solid, first_triangle)) {
  }
}

void drop_unused_points(IndexedMesh& mesh) {
  std::vector<std::uint32_t> new_index(mesh.points_mm.size(), 0);
  for (const Triangle& corners : mesh.triangles) {
    for (const std::uint32_t corner : corners) new_index[corner] = 1;
  }
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    if (new_index[i] == 0) continue;
    mesh.points_mm[count] = mesh.points_mm[i];
    new_index[i] = count++;
  }
  mesh.points_mm.resize(count);
  for (Triangle& corners : mesh.triangles) {
    for (std::uint32_t& corner : corners) corner = new_index[corner];
  }
}

}  // namespace hallux::simulator
