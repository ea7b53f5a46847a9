#include "tests/simulator/cutting/worlds/shown_solid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace hallux::tests {

using namespace simulator;

namespace {

/// Every directed edge, and every one turned round, each list ascending.
struct DirectedEdges {
  std::vector<std::uint64_t> forward, backward;

  explicit DirectedEdges(const IndexedMesh& mesh) {
    for (const Triangle& corners : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t from = corners[k], to = corners[(k + 1) % 3];
        forward.push_back(from << 32U | to);
        backward.push_back(to << 32U | from);
      }
    }
    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());
  }
};

bool is_finite(const Vec3& point_mm) {
  return std::isfinite(point_mm.x) && std::isfinite(point_mm.y) && std::isfinite(point_mm.z);
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t member) {
  while (parent[member] != member) member = parent[member] = parent[parent[member]];
  return member;
}

}  // namespace

IndexedMesh shown_mesh(const CutSolid& solid, const SolidPatch& patch) {
  IndexedMesh shown;
  shown.points_mm = solid.mesh.points_mm;
  shown.points_mm.insert(shown.points_mm.end(), patch.points_in_bone_mm.begin(),
                         patch.points_in_bone_mm.end());
  std::size_t next_hidden = 0;
  for (std::uint32_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    if (next_hidden < patch.hidden.size() && patch.hidden[next_hidden] == i) {
      ++next_hidden;
    } else {
      shown.triangles.push_back(solid.mesh.triangles[i]);
    }
  }
  shown.triangles.insert(shown.triangles.end(), patch.triangles.begin(), patch.triangles.end());
  return shown;
}

bool is_closed_as_chain(const IndexedMesh& mesh) {
  const DirectedEdges edges(mesh);
  return edges.forward == edges.backward;
}

bool is_strictly_closed(const IndexedMesh& mesh) {
  const DirectedEdges edges(mesh);
  if (edges.forward != edges.backward) return false;
  const auto repeated = std::adjacent_find(edges.forward.begin(), edges.forward.end());
  if (repeated != edges.forward.end()) return false;
  std::vector<bool> is_used(mesh.points_mm.size(), false);
  for (const Triangle& corners : mesh.triangles) {
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      return false;
    }
    for (const std::uint32_t corner : corners) is_used[corner] = true;
  }
  return std::all_of(is_used.begin(), is_used.end(), [](bool used) { return used; }) &&
         std::all_of(mesh.points_mm.begin(), mesh.points_mm.end(), is_finite);
}

std::vector<double> shell_volumes_mm3(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.points_mm.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (const Triangle& corners : mesh.triangles) {
    for (const std::uint32_t corner : {corners[1], corners[2]}) {
      const std::uint32_t a = root_of(parent, corners[0]), b = root_of(parent, corner);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<double> at_root(mesh.points_mm.size(), 0.0);
  std::vector<bool> is_shell(mesh.points_mm.size(), false);
  for (const Triangle& corners : mesh.triangles) {
    const std::uint32_t root = root_of(parent, corners[0]);
    is_shell[root] = true;
    at_root[root] += glm::dot(mesh.points_mm[corners[0]],
                              glm::cross(mesh.points_mm[corners[1]], mesh.points_mm[corners[2]])) /
                     6.0;
  }
  std::vector<double> volumes_mm3;
  for (std::size_t i = 0; i < at_root.size(); ++i) {
    if (is_shell[i]) volumes_mm3.push_back(at_root[i]);
  }
  return volumes_mm3;
}

std::size_t body_count(const IndexedMesh& mesh) {
  const std::vector<double> volumes_mm3 = shell_volumes_mm3(mesh);
  return static_cast<std::size_t>(
      std::count_if(volumes_mm3.begin(), volumes_mm3.end(),
                    [](double volume_mm3) { return volume_mm3 > debris_limit_mm3; }));
}

double patch_area_mm2(const CutSolid& solid, const SolidPatch& patch) {
  const std::size_t mesh_points = solid.mesh.points_mm.size();
  const auto place = [&](std::uint32_t point) {
    return point < mesh_points ? solid.mesh.points_mm[point]
                               : patch.points_in_bone_mm[point - mesh_points];
  };
  double area_mm2 = 0.0;
  for (const Triangle& corners : patch.triangles) {
    const Vec3 a = place(corners[0]);
    const Vec3 normal = glm::cross(place(corners[1]) - a, place(corners[2]) - a);
    area_mm2 += 0.5 * std::sqrt(glm::dot(normal, normal));
  }
  return area_mm2;
}

double balance_limit_mm3(const CutSolid& solid, const SolidPatch& patch) {
  // A step is 2^-20 mm as long as the slab's skin and the region stay within 64 mm; the doubling is
  // for larger ones.
  const double step_mm = 2.0 / 1048576.0;
  const double rounding_mm3 = 1e-12 * (1.0 + std::abs(signed_volume_mm3(solid.mesh)));
  return step_mm * patch_area_mm2(solid, patch) + rounding_mm3;
}

bool are_same(const SolidPatch& a, const SolidPatch& b) {
  return a.hidden == b.hidden && a.points_in_bone_mm == b.points_in_bone_mm &&
         a.parents == b.parents && a.triangles == b.triangles && a.sources == b.sources;
}

}  // namespace hallux::tests
