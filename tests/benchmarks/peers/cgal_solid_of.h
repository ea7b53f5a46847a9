/// CgalSolid for one kind of numbers: each is compiled in a source of its own, since each takes a
/// minute.
#pragma once

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>
#include <type_traits>

#include "tests/benchmarks/peers/cgal_solid.h"

namespace hallux::benchmarks {

template <CgalNumbers numbers>
struct CgalKernelOf;

template <CgalNumbers numbers>
struct CgalSolid<numbers>::Mesh {
  using Kernel = typename CgalKernelOf<numbers>::Type;

  CGAL::Surface_mesh<typename Kernel::Point_3> surface;
};

template <CgalNumbers numbers>
CgalSolid<numbers>::CgalSolid(const simulator::IndexedMesh& mesh)
    : mesh_(std::make_unique<Mesh>()) {
  using Point = typename Mesh::Kernel::Point_3;
  auto& surface = mesh_->surface;
  using Count = typename std::remove_reference_t<decltype(surface)>::size_type;
  const auto triangle_count = static_cast<Count>(mesh.triangles.size());
  surface.reserve(static_cast<Count>(mesh.points_mm.size()), triangle_count / 2 * 3,
                  triangle_count);
  for (const Vec3& point_mm : mesh.points_mm) {
    surface.add_vertex(Point(point_mm.x, point_mm.y, point_mm.z));
  }
  using Vertex = typename std::remove_reference_t<decltype(surface)>::Vertex_index;
  for (const simulator::Triangle& corners : mesh.triangles) {
    const auto face = surface.add_face(Vertex(corners[0]), Vertex(corners[1]), Vertex(corners[2]));
    if (!face.is_valid()) throw std::runtime_error("CGAL refuses a triangle of the mesh");
  }
}

template <CgalNumbers numbers>
CgalSolid<numbers>::~CgalSolid() = default;

template <CgalNumbers numbers>
CgalSolid<numbers>::CgalSolid(const CgalSolid& other)
    : mesh_(std::make_unique<Mesh>(*other.mesh_)) {}

template <CgalNumbers numbers>
CgalSolid<numbers>::CgalSolid(CgalSolid&& other) noexcept = default;

template <CgalNumbers numbers>
void CgalSolid<numbers>::clip(const HalfSpace& kept) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  const typename Mesh::Kernel::Plane_3 plane(kept.normal.x, kept.normal.y, kept.normal.z,
                                             -kept.offset_mm);
  if (!pmp::clip(mesh_->surface, plane, CGAL::parameters::clip_volume(true))) {
    throw std::runtime_error("CGAL could not clip");
  }
}

template <CgalNumbers numbers>
void CgalSolid<numbers>::split(const HalfSpace& plane) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  pmp::split(mesh_->surface, typename Mesh::Kernel::Plane_3(plane.normal.x, plane.normal.y,
                                                            plane.normal.z, -plane.offset_mm));
}

template <CgalNumbers numbers>
void CgalSolid<numbers>::subtract(CgalSolid& tool) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  if (!pmp::corefine_and_compute_difference(mesh_->surface, tool.mesh_->surface, mesh_->surface)) {
    throw std::runtime_error("CGAL could not subtract");
  }
}

template <CgalNumbers numbers>
std::size_t CgalSolid<numbers>::triangle_count() const {
  return mesh_->surface.number_of_faces();
}

template <CgalNumbers numbers>
bool CgalSolid<numbers>::is_closed() const {
  return CGAL::is_closed(mesh_->surface);
}

template <CgalNumbers numbers>
double CgalSolid<numbers>::volume_mm3() const {
  return CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh_->surface));
}

}  // namespace hallux::benchmarks
