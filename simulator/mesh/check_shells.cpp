/// Shells that share no edge are looked at one by one: each has a volume with a sign, a box and a
/// tree of its own. Solids whose surfaces meet do so where an edge of one pierces the other, and
/// where none does a single point of a shell says which others are around it.
#include <algorithm>
#include <string>

#include "simulator/base/disjoint_sets.h"
#include "simulator/mesh/bvh.h"
#include "simulator/mesh/edge_pairs.h"
#include "simulator/mesh/mesh_text.h"
#include "simulator/mesh/read_mesh.h"

namespace hallux::simulator {

namespace {

struct Box {
  Vec3 low{0.0}, high{0.0};

  bool meets(const Box& other) const noexcept {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y && low.z <= other.high.z && other.low.z <= high.z;
  }
};

Box box_of(const Vec3& a, const Vec3& b) noexcept { return {glm::min(a, b), glm::max(a, b)}; }

struct Shell {
  IndexedMesh mesh;
  Box box;
  double volume_mm3 = 0.0;
  Bvh tree;
};

Shell shell_of(const IndexedMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  IndexedMesh own;
  std::vector<std::uint32_t> used;
  for (const std::uint32_t triangle : triangles) {
    const Triangle& corners = mesh.triangles[triangle];
    used.insert(used.end(), corners.begin(), corners.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Box box{mesh.points_mm[used.front()], mesh.points_mm[used.front()]};
  for (const std::uint32_t point : used) {
    own.points_mm.push_back(mesh.points_mm[point]);
    box = {glm::min(box.low, own.points_mm.back()), glm::max(box.high, own.points_mm.back())};
  }
  const auto place_of = [&](std::uint32_t point) {
    return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), point) -
                                      used.begin());
  };
  for (const std::uint32_t triangle : triangles) {
    const Triangle& corners = mesh.triangles[triangle];
    own.triangles.push_back({place_of(corners[0]), place_of(corners[1]), place_of(corners[2])});
  }
  const double volume_mm3 = signed_volume_mm3(own);
  Bvh tree{own};
  return {std::move(own), box, volume_mm3, std::move(tree)};
}

/// By the edges that triangles share.
std::vector<Shell> shells_of(const IndexedMesh& mesh) {
  const EdgePairs pairs = pair_edges(mesh);
  DisjointSets sets(mesh.triangles.size());
  for (std::uint32_t edge = 0; edge < pairs.opposite.size(); ++edge) {
    if (pairs.opposite[edge] != no_half_edge) sets.join(edge / 3, pairs.opposite[edge] / 3);
  }
  const auto groups = sets.groups();
  std::vector<Shell> shells;
  if (groups.size() < 2) return shells;
  for (const auto& triangles : groups) shells.push_back(shell_of(mesh, triangles));
  return shells;
}

/// Where an edge of one goes through the surface of the other; not where it ends on it.
std::optional<Vec3> piercing_of(const Shell& edges_of, const Shell& surface) {
  constexpr double end_part = 1.0e-6;
  const IndexedMesh& mesh = edges_of.mesh;
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      // Each edge once.
      if (triangle[k] > triangle[(k + 1) % 3]) continue;
      const Vec3& from = mesh.points_mm[triangle[k]];
      const Vec3& to = mesh.points_mm[triangle[(k + 1) % 3]];
      const double length_mm = glm::length(to - from);
      if (length_mm <= 0.0 || !box_of(from, to).meets(surface.box)) continue;
      const Vec3 direction = (to - from) / length_mm;
      const auto hit = surface.tree.first_hit(from + end_part * (to - from), direction);
      const double within_mm = (1.0 - 2.0 * end_part) * length_mm;
      if (hit && hit->distance_mm < within_mm) return from + hit->distance_mm * direction;
    }
  }
  return std::nullopt;
}

void check_none_cross(const std::vector<Shell>& shells, std::string_view name) {
  for (std::size_t i = 0; i < shells.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!shells[i].box.meets(shells[j].box)) continue;
      std::optional<Vec3> place_mm = piercing_of(shells[i], shells[j]);
      if (!place_mm) place_mm = piercing_of(shells[j], shells[i]);
      if (!place_mm) continue;
      refuse_mesh(name, "has surfaces that cross (near " + place_text(*place_mm) +
                            "), and what lies in both would count twice; unite them in a mesh "
                            "editor");
    }
  }
}

/// The smallest of those that a shell lies in.
const Shell* around(const std::vector<Shell>& shells, const Shell& inner) {
  const Shell* smallest = nullptr;
  const Vec3& point = inner.mesh.points_mm.front();
  for (const Shell& outer : shells) {
    if (&outer == &inner || !outer.box.meets({point, point}) || !outer.tree.contains(point))
      continue;
    if (smallest == nullptr || std::abs(outer.volume_mm3) < std::abs(smallest->volume_mm3))
      smallest = &outer;
  }
  return smallest;
}

}  // namespace

void check_shells(const IndexedMesh& mesh, std::string_view name) {
  const std::vector<Shell> shells = shells_of(mesh);
  check_none_cross(shells, name);
  for (const Shell& shell : shells) {
    const Shell* const outer = around(shells, shell);
    const bool is_around_bone = outer == nullptr || outer->volume_mm3 < 0.0;
    if (is_around_bone == (shell.volume_mm3 > 0.0)) continue;
    const std::string place = " (near " + place_text(shell.mesh.points_mm.front()) + ")";
    if (!is_around_bone) {
      refuse_mesh(name, "has a surface inside another that faces outward as it does" + place +
                            ", and what lies in both would count twice; remove the inner one, or "
                            "turn it inside out where it is a canal");
    }
    refuse_mesh(name, "has a surface that faces inward and lies in no bone" + place +
                          "; flip its normals in a mesh editor, or remove it");
  }
}

}  // namespace hallux::simulator
