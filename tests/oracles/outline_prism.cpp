#include "tests/oracles/outline_prism.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>
#include <vector>

#include "simulator/base/check.h"

namespace hallux::oracles {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr int not_seen = -1;

struct Depth {
  int loops_around = not_seen;
};

using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<Depth, Kernel>>;
using Filling =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<Vertex, Face>>;

/// Calls `visit(corner, next)` along each loop.
template <typename Visit>
void for_edges(const simulator::RegionOutline& region, Visit visit) {
  std::uint32_t first = 0;
  for (const std::uint32_t last : region.loop_ends) {
    for (std::uint32_t i = first; i < last; ++i) visit(i, i + 1 < last ? i + 1 : first);
    first = last;
  }
}

/// Counts for each face how many loops lie around it, from the outside inward.
void count_loops(Filling& filling) {
  std::vector<std::pair<Filling::Face_handle, int>> stack{{filling.infinite_face(), 0}};
  while (!stack.empty()) {
    const auto [face, depth] = stack.back();
    stack.pop_back();
    if (face->info().loops_around != not_seen) continue;
    face->info().loops_around = depth;
    for (int edge = 0; edge < 3; ++edge) {
      stack.emplace_back(face->neighbor(edge), depth + (face->is_constrained(edge) ? 1 : 0));
    }
  }
}

}  // namespace

simulator::IndexedMesh prism_of(const simulator::RegionOutline& region,
                                const simulator::KerfPlane& plane) {
  Filling filling;
  std::vector<Filling::Vertex_handle> corners;
  for (const Vec2& corner_mm : region.corners_mm) {
    corners.push_back(filling.insert(Kernel::Point_2(corner_mm.x, corner_mm.y)));
    corners.back()->info() = static_cast<std::uint32_t>(corners.size() - 1);
  }
  CHECK(filling.number_of_vertices() == corners.size());
  for_edges(region, [&](std::uint32_t a, std::uint32_t b) {
    filling.insert_constraint(corners[a], corners[b]);
  });
  CHECK(filling.number_of_vertices() == corners.size());

  simulator::IndexedMesh prism;
  const double half_mm = 0.5 * plane.thickness_mm;
  for (const double height_mm : {-half_mm, half_mm}) {
    for (const Vec2& corner_mm : region.corners_mm) {
      prism.points_mm.push_back(
          transform_point(plane.bone_from_kerf, Vec3(corner_mm.x, corner_mm.y, height_mm)));
    }
  }
  const auto up = static_cast<std::uint32_t>(corners.size());
  count_loops(filling);
  for (const auto& face : filling.finite_face_handles()) {
    if (face->info().loops_around % 2 == 0) continue;
    const std::uint32_t a = face->vertex(0)->info(), b = face->vertex(1)->info(),
                        c = face->vertex(2)->info();
    prism.triangles.push_back({up + a, up + b, up + c});
    prism.triangles.push_back({a, c, b});
  }
  for_edges(region, [&](std::uint32_t a, std::uint32_t b) {
    prism.triangles.push_back({a, b, up + b});
    prism.triangles.push_back({a, up + b, up + a});
  });
  return prism;
}

}  // namespace hallux::oracles
