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

/// The volume enclosed by a closed mesh, negative for an inward-facing shell [mm3].
double signed_volume_mm3(const IndexedMesh& mesh) noexcept;
/// The name of the content: counts, coordinates bit for bit, indices.
Digest digest_of_mesh(const IndexedMesh& mesh) noexcept;
/// Appends the points and triangles of `added`.
void append_mesh(IndexedMesh& mesh, const IndexedMesh& added);

}  // namespace hallux::simulator
