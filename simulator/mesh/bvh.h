/// A bounding volume hierarchy over a closed mesh: nearest point, signed distance, rays and slabs.
///
/// The mesh must not change while the tree lives. Queries allocate nothing unless they fill a vector, and give the same
/// bits on every machine.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

struct NearestPoint {
  double distance_mm = 0.0;
  std::uint32_t triangle = 0;
  Vec3 point_mm{0.0, 0.0, 0.0};
  bool is_inside = false;  ///< by the angle-weighted pseudonormal (Baerentzen and Aanaes 2005)
};

struct RayHit {
  double distance_mm = 0.0;  ///< along the unit direction
  std::uint32_t triangle = 0;
};

class Bvh {
 public:
  /// Copies what it needs of the mesh.
  explicit Bvh(const IndexedMesh& mesh);
  ~Bvh();
  Bvh(Bvh&&) noexcept;
  Bvh& operator=(Bvh&&) noexcept;

  /// Nothing where no triangle is nearer than `within_mm`.
  /// thread  any; allocates nothing
  std::optional<NearestPoint> nearest(
      const Vec3& point_mm,
      double within_mm = std::numeric_limits<double>::infinity()) const noexcept;
  /// Negative inside [mm]. Where no surface is within `within_mm` the sign still holds and the size is `within_mm`.
  double signed_distance_mm(
      const Vec3& point_mm,
      double within_mm = std::numeric_limits<double>::infinity()) const noexcept;
  /// By the parity of crossings; agrees with the sign of the distance except on the surface.
  bool contains(const Vec3& point_mm) const noexcept;
  /// needs   direction has length 1
  std::optional<RayHit> first_hit(const Vec3& origin_mm, const Vec3& direction) const noexcept;
  /// Replaces `triangles` by those that reach into |normal . p - offset| <= half_mm, in ascending order.
  void triangles_in_slab(const Vec3& normal, double offset_mm, double half_mm,
                         std::vector<std::uint32_t>& triangles) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace hallux::simulator
