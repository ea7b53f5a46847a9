#include "simulator/mesh/solid_mesh.h"

#include <string>
#include <vector>

#include "simulator/base/check.h"
#include "simulator/mesh/edge_pairs.h"
#include "simulator/mesh/mesh_text.h"
#include "simulator/mesh/read_mesh.h"

namespace hallux::simulator {

namespace {

/// A point where two fans of triangles touch cannot be walked around on half-edges: each fan gets its own copy. The
/// surface stays the same, point by point.
IndexedMesh with_single_fans(const IndexedMesh& mesh) {
  const EdgePairs pairs = pair_edges(mesh);
  IndexedMesh split = mesh;
  std::vector<bool> has_fan(mesh.points_mm.size(), false);
  std::vector<bool> is_walked(pairs.opposite.size(), false);
  for (std::uint32_t h = 0; h < pairs.opposite.size(); ++h) {
    if (is_walked[h]) continue;
    const std::uint32_t point = origin_of(mesh, h);
    std::uint32_t own = point;
    if (has_fan[point]) {
      own = static_cast<std::uint32_t>(split.points_mm.size());
      split.points_mm.push_back(mesh.points_mm[point]);
    }
    has_fan[point] = true;
    for (std::uint32_t around = h; !is_walked[around];
         around = pairs.opposite[previous_in_triangle(around)]) {
      is_walked[around] = true;
      split.triangles[around / 3][around % 3] = own;
    }
  }
  return split;
}

HalfEdgeMesh half_edges_from(const IndexedMesh& mesh, std::string_view name) {
  HalfEdgeMesh half_edges;
  const std::size_t triangles = mesh.triangles.size();
  half_edges.reserve(mesh.points_mm.size(), 3 * triangles / 2, triangles);
  for (const Vec3& point : mesh.points_mm) half_edges.add_vertex({point.x, point.y, point.z});
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto corner = [&](std::size_t k) {
      return OpenMesh::VertexHandle(static_cast<int>(mesh.triangles[i][k]));
    };
    if (!half_edges.add_face(corner(0), corner(1), corner(2)).is_valid()) {
      refuse_mesh(name, "triangle " + std::to_string(i + 1) + " (near " +
                            place_text(mesh.points_mm[mesh.triangles[i][0]]) +
                            ") does not fit its neighbours; repair the mesh in a mesh editor");
    }
  }
  CHECK(half_edges.n_faces() == triangles && half_edges.n_edges() * 2 == triangles * 3);
  return half_edges;
}

}  // namespace

HalfEdgeMesh half_edges_of(const IndexedMesh& mesh, std::string_view name) {
  check_closed_solid(mesh, name);
  return half_edges_from(with_single_fans(mesh), name);
}

SolidMesh::SolidMesh(const IndexedMesh& mesh, std::string_view name)
    : mesh_(half_edges_of(mesh, name)) {}

IndexedMesh SolidMesh::indexed() const {
  IndexedMesh mesh;
  mesh.points_mm.reserve(mesh_.n_vertices());
  for (const auto vertex : mesh_.vertices()) {
    const OpenMesh::Vec3d& point = mesh_.point(vertex);
    mesh.points_mm.emplace_back(point[0], point[1], point[2]);
  }
  mesh.triangles.reserve(mesh_.n_faces());
  for (const auto face : mesh_.faces()) {
    Triangle triangle{};
    std::size_t corner = 0;
    for (const auto vertex : face.vertices()) {
      triangle[corner++] = static_cast<std::uint32_t>(vertex.idx());
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

double SolidMesh::volume_mm3() const noexcept {
  const OpenMesh::Vec3d apex = mesh_.point(OpenMesh::VertexHandle(0));
  double six_volumes_mm3 = 0.0;
  for (const auto face : mesh_.faces()) {
    auto corner = mesh_.cfv_iter(face);
    const OpenMesh::Vec3d a = mesh_.point(*corner++) - apex;
    const OpenMesh::Vec3d b = mesh_.point(*corner++) - apex;
    const OpenMesh::Vec3d c = mesh_.point(*corner) - apex;
    six_volumes_mm3 += OpenMesh::dot(a, OpenMesh::cross(b, c));
  }
  return six_volumes_mm3 / 6.0;
}

}  // namespace hallux::simulator
