/// A closed, oriented triangle mesh on OpenMesh's half-edges: the form in which bones are cut and walked.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstddef>
#include <string_view>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

struct SolidTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<SolidTraits>;

/// The half-edges of a closed, oriented mesh; triangle i becomes face i and, but for copies behind them, point i vertex i.
/// ensures every triangle is kept; a point where several fans of triangles touch becomes one point per fan
/// errors  MeshError (see check_closed_solid), naming `name`
HalfEdgeMesh half_edges_of(const IndexedMesh& mesh, std::string_view name);

/// Always closed and oriented: it cannot be made from anything else.
class SolidMesh {
 public:
  /// By half_edges_of.
  SolidMesh(const IndexedMesh& mesh, std::string_view name);

  const HalfEdgeMesh& half_edges() const noexcept { return mesh_; }
  IndexedMesh indexed() const;
  std::size_t triangle_count() const noexcept { return mesh_.n_faces(); }
  double volume_mm3() const noexcept;

 private:
  HalfEdgeMesh mesh_;
};

}  // namespace hallux::simulator
