#include "scenarios/foot/half_edge_surface.h"

#include <cstdint>

#include "scenarios/scenario_error.h"

namespace hallux::scenarios {

using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

HalfEdgeSurface half_edges_from(const simulator::IndexedMesh& mesh) {
  HalfEdgeSurface surface;
  surface.points_mm = mesh.points_mm;
  OpenMesh::TriConnectivity& connections = surface.connections;
  connections.reserve(mesh.points_mm.size(), mesh.triangles.size() * 3 / 2, mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) connections.add_vertex();
  bool fits = true;
  for (const simulator::Triangle& t : mesh.triangles) {
    const auto corner = [&t](std::size_t k) { return VertexHandle(static_cast<int>(t[k])); };
    fits = fits && connections.add_face(corner(0), corner(1), corner(2)).is_valid();
  }
  if (!fits || 2 * connections.n_edges() != 3 * connections.n_faces()) {
    throw ScenarioError("the generated surface is open; ask for a finer edge length");
  }
  connections.request_vertex_status();
  connections.request_edge_status();
  connections.request_face_status();
  return surface;
}

simulator::IndexedMesh indexed_from(const HalfEdgeSurface& surface) {
  const OpenMesh::TriConnectivity& connections = surface.connections;
  simulator::IndexedMesh mesh;
  std::vector<std::uint32_t> number(connections.n_vertices(), 0);
  for (const VertexHandle v : connections.vertices()) {
    number[static_cast<std::size_t>(v.idx())] = static_cast<std::uint32_t>(mesh.points_mm.size());
    mesh.points_mm.push_back(surface.at(v));
  }
  for (const FaceHandle f : connections.faces()) {
    simulator::Triangle& triangle = mesh.triangles.emplace_back();
    std::size_t k = 0;
    for (const VertexHandle v : connections.fv_range(f)) {
      triangle[k++] = number[static_cast<std::size_t>(v.idx())];
    }
  }
  return mesh;
}

}  // namespace hallux::scenarios
