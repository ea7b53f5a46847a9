/// removed = integral of the section's area A(z) over the slab.
///
/// A(z) is the sum over triangles of half the cross product of the segment that the plane at z cuts
/// from each. Segment ends move linearly in z, so each triangle's term is a quadratic between its
/// corner heights, and Simpson's rule is exact on it. Nothing here is shared with the clip: own
/// heights, own search, own labels.
#include "simulator/cutting/solid/slab_volume.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "simulator/base/check.h"

namespace hallux::simulator {

namespace {

constexpr std::uint32_t no_label = std::numeric_limits<std::uint32_t>::max();

struct Slab {
  Vec3 middle_mm, up;
  double half_mm = 0.0;

  double height_of(const Vec3& point_mm) const noexcept {
    return glm::dot(up, point_mm) - glm::dot(up, middle_mm);
  }
};

/// A triangle with its corners sorted by height.
struct SortedTriangle {
  std::array<Vec3, 3> corners_mm;  // from the middle of the slab
  std::array<double, 3> heights_mm{};
  double turn = 1.0;  // -1 where sorting turned the triangle over
};

SortedTriangle sorted_by_height(const IndexedMesh& mesh, const Slab& slab,
                                const Triangle& corners) {
  SortedTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.corners_mm[i] = mesh.points_mm[corners[i]] - slab.middle_mm;
    triangle.heights_mm[i] = slab.height_of(mesh.points_mm[corners[i]]);
  }
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{0}}) {
    if (triangle.heights_mm[i] <= triangle.heights_mm[i + 1]) continue;
    std::swap(triangle.corners_mm[i], triangle.corners_mm[i + 1]);
    std::swap(triangle.heights_mm[i], triangle.heights_mm[i + 1]);
    triangle.turn = -triangle.turn;
  }
  return triangle;
}

Vec3 edge_at(const SortedTriangle& triangle, std::size_t low, std::size_t high, double z_mm) {
  const double rise_mm = triangle.heights_mm[high] - triangle.heights_mm[low];
  const double part = (z_mm - triangle.heights_mm[low]) / rise_mm;
  return triangle.corners_mm[low] + part * (triangle.corners_mm[high] - triangle.corners_mm[low]);
}

/// The triangle's term of A(z), between its corners low and low + 1 in height: the long edge runs
/// from lowest to highest, and seen from outside with corners counter-clockwise the contour walks
/// from the middle corner's side to it or back, as the turn says.
double area_term_mm2(const SortedTriangle& triangle, const Vec3& up, std::size_t low, double z_mm) {
  const Vec3 on_long_edge = edge_at(triangle, 0, 2, z_mm);
  const Vec3 on_short_edge = edge_at(triangle, low, low + 1, z_mm);
  return 0.5 * triangle.turn * glm::dot(up, glm::cross(on_long_edge, on_short_edge));
}

double volume_term_mm3(const SortedTriangle& triangle, const Slab& slab) {
  double sum_mm3 = 0.0;
  for (std::size_t low = 0; low < 2; ++low) {
    const double from_mm = std::max(triangle.heights_mm[low], -slab.half_mm);
    const double to_mm = std::min(triangle.heights_mm[low + 1], slab.half_mm);
    if (from_mm >= to_mm) continue;
    const double areas_mm2 = area_term_mm2(triangle, slab.up, low, from_mm) +
                             4.0 * area_term_mm2(triangle, slab.up, low, 0.5 * (from_mm + to_mm)) +
                             area_term_mm2(triangle, slab.up, low, to_mm);
    sum_mm3 += (to_mm - from_mm) / 6.0 * areas_mm2;
  }
  return sum_mm3;
}

bool reaches_into_slab(const Slab& slab, const IndexedMesh& mesh,
                       std::span<const std::uint32_t> corners) {
  double lowest_mm = std::numeric_limits<double>::infinity(), highest_mm = -lowest_mm;
  for (const std::uint32_t corner : corners) {
    lowest_mm = std::min(lowest_mm, slab.height_of(mesh.points_mm[corner]));
    highest_mm = std::max(highest_mm, slab.height_of(mesh.points_mm[corner]));
  }
  return lowest_mm <= slab.half_mm && highest_mm >= -slab.half_mm;
}

struct SharedEdge {
  std::array<std::uint32_t, 2> points{};
  std::uint32_t triangle = 0;
};

/// The triangles that reach into the slab, labelled: those joined by edges that reach into it have
/// one label.
class SlabSkin {
 public:
  SlabSkin(const IndexedMesh& mesh, const Slab& slab) : label_(mesh.triangles.size(), no_label) {
    std::vector<SharedEdge> edges;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& corners = mesh.triangles[i];
      if (!reaches_into_slab(slab, mesh, corners)) continue;
      label_[i] = i;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array<std::uint32_t, 2> edge{corners[k], corners[(k + 1) % 3]};
        if (!reaches_into_slab(slab, mesh, edge)) continue;
        edges.push_back({{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}, i});
      }
    }
    std::sort(edges.begin(), edges.end(),
              [](const SharedEdge& a, const SharedEdge& b) { return a.points < b.points; });
    for (std::size_t i = 1; i < edges.size(); ++i) {
      if (edges[i].points != edges[i - 1].points) continue;
      label_[label_of(edges[i].triangle)] = label_of(edges[i - 1].triangle);
    }
  }
  bool has(std::uint32_t triangle) const noexcept { return label_[triangle] != no_label; }
  std::uint32_t label_of(std::uint32_t triangle) noexcept {
    while (label_[triangle] != triangle) {
      label_[triangle] = label_[label_[triangle]];
      triangle = label_[triangle];
    }
    return triangle;
  }

 private:
  std::vector<std::uint32_t> label_;
};

}  // namespace

double slab_volume_mm3(const CutSolid& solid, const Section& section,
                       std::span<const std::uint8_t> is_removed) {
  CHECK(is_removed.size() == section.regions.size());
  const IndexedMesh& mesh = solid.mesh;
  const RigidTransform& bone_from_kerf = section.plane.bone_from_kerf;
  const Slab slab{bone_from_kerf.translation_mm, axis_z(bone_from_kerf),
                  0.5 * section.plane.thickness_mm};
  SlabSkin skin(mesh, slab);
  std::vector<bool> is_label_removed(mesh.triangles.size(), false);
  for (std::size_t i = 0; i < section.regions.size(); ++i) {
    if (is_removed[i] == 0) continue;
    for (const std::uint32_t triangle : section.regions[i].triangles) {
      if (skin.has(triangle)) is_label_removed[skin.label_of(triangle)] = true;
    }
  }
  double volume_mm3 = 0.0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!skin.has(i) || !is_label_removed[skin.label_of(i)]) continue;
    volume_mm3 += volume_term_mm3(sorted_by_height(mesh, slab, mesh.triangles[i]), slab);
  }
  return volume_mm3;
}

}  // namespace hallux::simulator
