/// A closed triangle surface on OpenMesh's half-edges, with its points beside it.
/// Inside this corner only.
///
/// OpenMesh alone changes the connections: its split, collapse and flip, after its own checks.
/// A collapse only marks what it deletes: handles stay valid until `indexed_from` numbers the rest.
#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <cstddef>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::scenarios {

struct HalfEdgeSurface {
  OpenMesh::TriConnectivity connections;
  /// By vertex, in the bone frame [mm].
  std::vector<Vec3> points_mm;

  const Vec3& at(OpenMesh::VertexHandle v) const {
    return points_mm[static_cast<std::size_t>(v.idx())];
  }
  Vec3& at(OpenMesh::VertexHandle v) { return points_mm[static_cast<std::size_t>(v.idx())]; }
};

/// The half-edges of a closed mesh.
/// ensures point i is vertex i and triangle i face i; status rows for what collapses delete
/// errors  ScenarioError where the mesh is open, or two fans of triangles meet in one point only
HalfEdgeSurface half_edges_from(const simulator::IndexedMesh& mesh);

/// The vertices and faces that are not deleted, numbered again in their order.
simulator::IndexedMesh indexed_from(const HalfEdgeSurface& surface);

}  // namespace hallux::scenarios
