#include <string>

#include "simulator/mesh/edge_pairs.h"
#include "simulator/mesh/mesh_text.h"
#include "simulator/mesh/read_mesh.h"

namespace hallux::simulator {

namespace {

bool is_usable(double coordinate_mm) noexcept {
  return coordinate_mm >= -largest_coordinate_mm && coordinate_mm <= largest_coordinate_mm;
}

void check_points(const IndexedMesh& mesh, std::string_view name) {
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
    const Vec3& point = mesh.points_mm[i];
    if (is_usable(point.x) && is_usable(point.y) && is_usable(point.z)) continue;
    const std::string which = "point " + std::to_string(i + 1);
    if (!is_finite(point)) refuse_not_finite(name, which);
    refuse_mesh(
        name,
        which + " is more than a kilometre away; export the bone in millimetres, near the origin");
  }
}

void check_triangles(const IndexedMesh& mesh, std::string_view name) {
  if (mesh.triangles.empty()) {
    refuse_mesh(name, "has no triangles; export the bone's surface as triangles");
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& triangle = mesh.triangles[i];
    for (const std::uint32_t index : triangle) {
      if (index < mesh.points_mm.size()) continue;
      refuse_mesh(name, "triangle " + std::to_string(i + 1) + " names point " +
                            std::to_string(index) + ", but there are " +
                            std::to_string(mesh.points_mm.size()) + "; export the mesh again");
    }
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
      refuse_mesh(name, "triangle " + std::to_string(i + 1) + " has the same corner twice (near " +
                            place_text(mesh.points_mm[triangle[0]]) +
                            "); remove degenerate faces in a mesh editor");
    }
  }
}

void refuse_edges(const IndexedMesh& mesh, std::string_view name, const EdgeFault& fault,
                  const std::string& what, const std::string& mend) {
  if (fault.count == 0) return;
  const Vec3 middle_mm = 0.5 * (mesh.points_mm[origin_of(mesh, fault.first)] +
                                mesh.points_mm[origin_of(mesh, next_in_triangle(fault.first))]);
  const std::string who = fault.count == 1 ? "1 edge " : std::to_string(fault.count) + " edges ";
  refuse_mesh(name, who + what + " (first near " + place_text(middle_mm) + "); " + mend);
}

}  // namespace

void check_closed_solid(const IndexedMesh& mesh, std::string_view name) {
  check_points(mesh, name);
  check_triangles(mesh, name);
  const EdgePairs pairs = pair_edges(mesh);
  const auto of = [](const EdgeFault& fault, const char* one, const char* many) {
    return std::string{fault.count == 1 ? one : many};
  };
  refuse_edges(mesh, name, pairs.open,
               of(pairs.open, "belongs", "belong") + " to one triangle only",
               "the bone must be closed, fill its holes in a mesh editor");
  refuse_edges(mesh, name, pairs.crowded,
               of(pairs.crowded, "belongs", "belong") + " to three triangles or more",
               "the bone must be one surface, remove inner or doubled faces in a mesh editor");
  refuse_edges(mesh, name, pairs.twisted,
               of(pairs.twisted, "is", "are") + " walked in the same direction by both triangles",
               "all faces must look outward, unify the normals in a mesh editor");
  const double volume_mm3 = signed_volume_mm3(mesh);
  if (volume_mm3 > 0.0) return;
  if (volume_mm3 < 0.0) {
    refuse_mesh(name, "is inside out (near " + place_text(mesh.points_mm.front()) +
                          " its faces look inward); flip the normals in a mesh editor");
  }
  refuse_mesh(name, "encloses no volume (near " + place_text(mesh.points_mm.front()) +
                        "); export the bone's whole surface");
}

}  // namespace hallux::simulator
