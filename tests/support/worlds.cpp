#include "tests/support/worlds.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux::tests {

namespace {

using simulator::IndexedMesh;
using simulator::Triangle;
using Node = std::array<std::size_t, 3>;

/// A lattice of planes along each axis; the solid is the union of some of its cells.
struct Lattice {
  std::array<std::vector<double>, 3> planes_mm;
};

/// Collects the faces between full and empty cells; corners are shared by their lattice node.
class CellSurface {
 public:
  explicit CellSurface(const Lattice& lattice) : lattice_(lattice) {}

  void add_quad(const std::array<Node, 4>& corners) {
    const std::array<std::uint32_t, 4> index{point(corners[0]), point(corners[1]),
                                             point(corners[2]), point(corners[3])};
    mesh_.triangles.push_back({index[0], index[1], index[2]});
    mesh_.triangles.push_back({index[0], index[2], index[3]});
  }
  IndexedMesh take() { return std::move(mesh_); }

 private:
  std::uint32_t point(const Node& node) {
    const auto next = static_cast<std::uint32_t>(mesh_.points_mm.size());
    const auto [place, is_new] = index_of_.emplace(node, next);
    if (is_new) {
      mesh_.points_mm.emplace_back(lattice_.planes_mm[0][node[0]], lattice_.planes_mm[1][node[1]],
                                   lattice_.planes_mm[2][node[2]]);
    }
    return place->second;
  }

  const Lattice& lattice_;
  std::map<Node, std::uint32_t> index_of_;
  IndexedMesh mesh_;
};

/// The corners of the face of `cell` that looks along +axis or -axis, counter-clockwise seen from
/// outside.
std::array<Node, 4> face_of_cell(const Node& cell, std::size_t axis, bool looks_up) {
  const std::size_t second = (axis + 1) % 3;
  const std::size_t third = (axis + 2) % 3;
  std::array<Node, 4> corners{cell, cell, cell, cell};
  for (Node& corner : corners) corner[axis] += looks_up ? 1 : 0;
  ++corners[1][second];
  ++corners[2][second];
  ++corners[2][third];
  ++corners[3][third];
  if (!looks_up) std::swap(corners[1], corners[3]);
  return corners;
}

IndexedMesh surface_of_cells(const Lattice& lattice,
                             const std::function<bool(const Node&)>& is_full) {
  Node count{};
  for (std::size_t axis = 0; axis < 3; ++axis) count[axis] = lattice.planes_mm[axis].size() - 1;
  CellSurface surface{lattice};
  const auto add_faces = [&](const Node& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool looks_up : {false, true}) {
        Node beside = cell;
        beside[axis] += looks_up ? std::size_t{1} : static_cast<std::size_t>(-1);
        if (beside[axis] >= count[axis] || !is_full(beside)) {
          surface.add_quad(face_of_cell(cell, axis, looks_up));
        }
      }
    }
  };
  for (std::size_t i = 0; i < count[0]; ++i) {
    for (std::size_t j = 0; j < count[1]; ++j) {
      for (std::size_t k = 0; k < count[2]; ++k) {
        if (is_full({i, j, k})) add_faces({i, j, k});
      }
    }
  }
  return surface.take();
}

std::vector<double> ends(double size_mm) { return {-0.5 * size_mm, 0.5 * size_mm}; }

/// A closed prism over a regular polygon around the x axis, with a point in the middle of each end.
IndexedMesh prism(double radius_mm, double length_mm, std::size_t segments, std::size_t rings) {
  IndexedMesh mesh;
  for (std::size_t ring = 0; ring <= rings; ++ring) {
    const double part = static_cast<double>(ring) / static_cast<double>(rings);
    for (std::size_t i = 0; i < segments; ++i) {
      const double angle_rad = 2.0 * pi * static_cast<double>(i) / static_cast<double>(segments);
      mesh.points_mm.emplace_back((part - 0.5) * length_mm, radius_mm * elementary::cos(angle_rad),
                                  radius_mm * elementary::sin(angle_rad));
    }
  }
  const auto at = [segments](std::size_t ring, std::size_t i) {
    return static_cast<std::uint32_t>(ring * segments + i % segments);
  };
  const auto first_end = static_cast<std::uint32_t>(mesh.points_mm.size());
  mesh.points_mm.emplace_back(-0.5 * length_mm, 0.0, 0.0);
  mesh.points_mm.emplace_back(0.5 * length_mm, 0.0, 0.0);
  for (std::size_t i = 0; i < segments; ++i) {
    mesh.triangles.push_back({first_end, at(0, i + 1), at(0, i)});
    mesh.triangles.push_back({first_end + 1, at(rings, i), at(rings, i + 1)});
    for (std::size_t ring = 0; ring < rings; ++ring) {
      mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
    }
  }
  return mesh;
}

}  // namespace

IndexedMesh solid_block(const Vec3& size_mm) {
  return surface_of_cells({{ends(size_mm.x), ends(size_mm.y), ends(size_mm.z)}},
                          [](const Node&) { return true; });
}

IndexedMesh two_blocks(const Vec3& size_mm, double gap_mm) {
  const double half_gap_mm = 0.5 * gap_mm;
  const std::vector<double> along{-half_gap_mm - size_mm.x, -half_gap_mm, half_gap_mm,
                                  half_gap_mm + size_mm.x};
  return surface_of_cells({{along, ends(size_mm.y), ends(size_mm.z)}},
                          [](const Node& cell) { return cell[0] != 1; });
}

IndexedMesh u_shape(const Vec3& size_mm, double wall_mm) {
  const Vec3 half_mm = 0.5 * size_mm;
  const std::vector<double> across{-half_mm.x, wall_mm - half_mm.x, half_mm.x - wall_mm, half_mm.x};
  const std::vector<double> upward{-half_mm.y, wall_mm - half_mm.y, half_mm.y};
  return surface_of_cells({{across, upward, ends(size_mm.z)}},
                          [](const Node& cell) { return !(cell[0] == 1 && cell[1] == 1); });
}

IndexedMesh hollow_tube(const Tube& tube) {
  IndexedMesh mesh = prism(tube.outer_radius_mm, tube.length_mm, tube.segments, tube.rings);
  if (tube.inner_radius_mm > 0.0) {
    append_mesh(mesh, inside_out(prism(tube.inner_radius_mm, tube.length_mm - 2.0 * tube.cap_mm,
                                       tube.segments, tube.rings)));
  }
  return mesh;
}

IndexedMesh sphere(double radius_mm, std::size_t subdivisions) {
  std::vector<double> planes(subdivisions + 1);
  for (std::size_t i = 0; i <= subdivisions; ++i) {
    planes[i] = 2.0 * static_cast<double>(i) / static_cast<double>(subdivisions) - 1.0;
  }
  IndexedMesh mesh = surface_of_cells({{planes, planes, planes}}, [](const Node&) { return true; });
  for (Vec3& point : mesh.points_mm) point *= radius_mm / std::sqrt(glm::dot(point, point));
  return mesh;
}

IndexedMesh dense_sphere(double radius_mm, std::size_t triangle_count) {
  std::size_t subdivisions = 1;
  while (12 * subdivisions * subdivisions < triangle_count) ++subdivisions;
  return sphere(radius_mm, subdivisions);
}

IndexedMesh moved(const IndexedMesh& mesh, const RigidTransform& motion) {
  IndexedMesh result = mesh;
  for (Vec3& point : result.points_mm) point = transform_point(motion, point);
  return result;
}

IndexedMesh inside_out(const IndexedMesh& mesh) {
  IndexedMesh result = mesh;
  for (Triangle& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
  return result;
}

}  // namespace hallux::tests
