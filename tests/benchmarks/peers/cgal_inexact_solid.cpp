#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "tests/benchmarks/peers/cgal_solid_of.h"

namespace hallux::benchmarks {

template <>
struct CgalKernelOf<CgalNumbers::Inexact> {
  using Type = CGAL::Exact_predicates_inexact_constructions_kernel;
};

template class CgalSolid<CgalNumbers::Inexact>;

simulator::IndexedMesh box_in_kerf(const simulator::KerfPlane& plane, const Vec3& low_in_kerf_mm,
                                   const Vec3& high_in_kerf_mm) {
  simulator::IndexedMesh box;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 point_mm((corner & 1U) != 0 ? high_in_kerf_mm.x : low_in_kerf_mm.x,
                        (corner & 2U) != 0 ? high_in_kerf_mm.y : low_in_kerf_mm.y,
                        (corner & 4U) != 0 ? high_in_kerf_mm.z : low_in_kerf_mm.z);
    box.points_mm.push_back(transform_point(plane.bone_from_kerf, point_mm));
  }
  box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return box;
}

simulator::IndexedMesh slab_box(const simulator::KerfPlane& plane) {
  constexpr double reach_mm = 200.0;
  const double half_mm = 0.5 * plane.thickness_mm;
  return box_in_kerf(plane, Vec3(-reach_mm, -reach_mm, -half_mm),
                     Vec3(reach_mm, reach_mm, half_mm));
}

}  // namespace hallux::benchmarks
