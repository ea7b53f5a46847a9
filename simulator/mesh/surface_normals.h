/// Normals that tell inside from outside at any nearest point of a closed mesh.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/mesh/closest_point.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

class SurfaceNormals {
 public:
  SurfaceNormals() = default;
  explicit SurfaceNormals(const IndexedMesh& mesh);

  /// The pseudonormal at the closest point on `triangle`: of the face, the sum over the edge's two
  /// faces, or the sum over the corner's faces weighted by their angles there. Zero where a sliver
  /// takes part, which has no normal.
  /// source  Baerentzen and Aanaes, Signed distance computation using the angle weighted
  ///         pseudonormal (2005)
  Vec3 at(std::uint32_t triangle, const ClosestPoint& closest) const noexcept;
  /// Too thin for a plane of its own.
  bool is_sliver(std::uint32_t triangle) const noexcept;

 private:
  std::vector<Triangle> triangles_;
  /// Per half-edge, see edge_pairs.h.
  std::vector<std::uint32_t> opposite_;
  /// Per triangle.
  std::vector<Vec3> unit_normal_;
  /// Per point.
  std::vector<Vec3> point_normal_;
};

}  // namespace hallux::simulator
