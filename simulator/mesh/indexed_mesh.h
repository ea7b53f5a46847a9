/// Triangles by index: the plain form in which meshes are read, generated, stored, searched and
/// written.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulator/base/digest.h"
#include "simulator/base/vector.h"

namespace hallux::simulator {

/// Point indices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

struct IndexedMesh {
  std::vector<Vec3> points_mm;
  std::vector<Triangle> triangles;

  friend bool operator==(const IndexedMesh&, const IndexedMesh&) = default;
};

inline std::array<Vec3, 3> corners_of(const IndexedMesh& mesh, std::size_t triangle) noexcept {
  const Triangle& corners = mesh.triangles[triangle];
  return {mesh.points_mm[corners[0]], mesh.points_mm[corners[1]], mesh.points_mm[corners[2]]};
}
inline Vec3 middle_of(const std::array<Vec3, 3>& corners_mm) noexcept {
  return (corners_mm[0] + corners_mm[1] + corners_mm[2]) / 3.0;
}

/// The volume enclosed by a closed mesh, negative for an inward-facing shell [mm3].
double signed_volume_mm3(const IndexedMesh& mesh) noexcept;
/// The name of the content: counts, coordinates bit for bit, indices.
Digest digest_of_mesh(const IndexedMesh& mesh) noexcept;
/// Appends the points and triangles of `added`.
void append_mesh(IndexedMesh& mesh, const IndexedMesh& added);

}  // namespace hallux::simulator
