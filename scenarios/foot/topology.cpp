#include "scenarios/foot/topology.h"

#include <algorithm>
#include <string>

#include "scenarios/scenario_error.h"
#include "simulator/base/disjoint_sets.h"
#include "simulator/mesh/edge_pairs.h"

namespace hallux::scenarios {
Topology topology_of(const simulator::IndexedMesh& mesh) {
  const simulator::EdgePairs pairs = simulator::pair_edges(mesh);
  const auto half_edges = static_cast<std::int64_t>(pairs.opposite.size());
  const std::size_t faulty = pairs.open.count + pairs.crowded.count + pairs.twisted.count;
  Topology topology;
  topology.unpaired_edges =
      std::count(pairs.opposite.begin(), pairs.opposite.end(), simulator::no_half_edge);
  const std::int64_t edges =
      (half_edges - topology.unpaired_edges) / 2 + static_cast<std::int64_t>(faulty);
  DisjointSets parts(mesh.points_mm.size());
  for (const simulator::Triangle& t : mesh.triangles) {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  for (std::uint32_t p = 0; p < mesh.points_mm.size(); ++p) {
    if (parts.root(p) == p) ++topology.components;
  }
  topology.euler_number =
      static_cast<std::int64_t>(mesh.points_mm.size() + mesh.triangles.size()) - edges;
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
