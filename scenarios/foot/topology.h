/// What a surface is: closed or not, in how many parts, with how many handles.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <string_view>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::scenarios {

struct Topology {
  /// Directed edges without exactly one opposite.
  std::int64_t unpaired_edges = 0;
  std::int64_t components = 0;
  /// Points - edges + triangles; 2 for a closed sphere.
  std::int64_t euler_number = 0;
};

Topology topology_of(const simulator::IndexedMesh& mesh);

/// errors  ScenarioError unless the surface is closed, in one part and without handles; names
///         `surface` and the fault
void check_sphere(const simulator::IndexedMesh& mesh, std::string_view surface);

}  // namespace hallux::scenarios
