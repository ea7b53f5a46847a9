#include "scenarios/foot/topology.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "scenarios/scenario_error.h"

namespace hallux::scenarios {
namespace {

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t point) {
  while (parent[point] != point) {
    parent[point] = parent[parent[point]];
    point = parent[point];
  }
  return point;
}

/// Directed edges as {lower point, higher point, direction}, sorted so that the two of an edge are
/// neighbours.
std::vector<std::uint64_t> sorted_edges(const simulator::IndexedMesh& mesh) {
  std::vector<std::uint64_t> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const simulator::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t from = t[k];
      const std::uint64_t to = t[(k + 1) % 3];
      edges.push_back((std::min(from, to) << 33U) | (std::max(from, to) << 1U) |
                      (from < to ? 0U : 1U));
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

Topology topology_of(const simulator::IndexedMesh& mesh) {
  Topology topology;
  std::int64_t edge_count = 0;
  const std::vector<std::uint64_t> edges = sorted_edges(mesh);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && (edges[end] >> 1U) == (edges[i] >> 1U)) ++end;
    const bool is_pair = end - i == 2 && edges[i] != edges[i + 1];
    if (!is_pair) topology.unpaired_edges += static_cast<std::int64_t>(end - i);
    ++edge_count;
    i = end;
  }
  std::vector<std::uint32_t> parent(mesh.points_mm.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (const simulator::Triangle& t : mesh.triangles) {
    parent[root_of(parent, t[1])] = root_of(parent, t[0]);
    parent[root_of(parent, t[2])] = root_of(parent, t[0]);
  }
  for (std::uint32_t p = 0; p < parent.size(); ++p) {
    if (parent[p] == p) ++topology.components;
  }
  topology.euler_number = static_cast<std::int64_t>(mesh.points_mm.size()) - edge_count +
                          static_cast<std::int64_t>(mesh.triangles.size());
  return topology;
}

void check_sphere(const simulator::IndexedMesh& mesh, std::string_view surface) {
  const Topology t = topology_of(mesh);
  const std::string who = "the generated " + std::string(surface);
  if (mesh.triangles.empty()) {
    throw ScenarioError(who + " is empty; ask for a bone nearer to its table's length");
  }
  if (t.unpaired_edges != 0) {
    throw ScenarioError(who + " is open: " + std::to_string(t.unpaired_edges) +
                        " edges have no partner; ask for a finer edge length");
  }
  if (t.components != 1) {
    throw ScenarioError(who + " came out in " + std::to_string(t.components) +
                        " parts; ask for a finer edge length or a bone nearer to its table");
  }
  if (t.euler_number != 2) {
    throw ScenarioError(who + " has " + std::to_string((2 - t.euler_number) / 2) +
                        " handles; ask for a finer edge length or a bone nearer to its table");
  }
}

}  // namespace hallux::scenarios
