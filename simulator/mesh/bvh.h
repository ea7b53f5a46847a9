/// A bounding volume hierarchy over a closed mesh: nearest point, signed distance, rays and slabs.
///
/// The mesh must not change while the tree lives. Queries allocate nothing unless they fill a
/// vector, and give the same bits on every machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

struct NearestPoint {
  double distance_mm = 0.0;
  std::uint32_t triangle = 0;
  Vec3 point_mm{0.0, 0.0, 0.0};
  /// By the angle-weighted pseudonormal (Baerentzen and Aanaes 2005).
  bool is_inside = false;
};

struct RayHit {
  /// Along the unit direction.
  double distance_mm = 0.0;
  std::uint32_t triangle = 0;
};

/// A triangle that a query comes by, and its point nearest to the one asked about.
struct NearTriangle {
  std::uint32_t triangle = 0;
  const std::array<Vec3, 3>& corner_mm;
  Vec3 closest_mm{0.0, 0.0, 0.0};
};

/// How a tree is built; distances, hits and slabs do not depend on it, only their cost
/// (docs/performance.md).
struct BvhBuild {
  /// Most triangles in a leaf; at least 1.
  std::uint32_t leaf_size = 4;
  /// From here on by halves; 0: everywhere; at most 44.
  std::size_t halving_depth = 44;
};

class Bvh {
 public:
  /// Copies what it needs of the mesh.
  explicit Bvh(const IndexedMesh& mesh, const BvhBuild& build = {});
  ~Bvh();
  Bvh(Bvh&&) noexcept;
  Bvh& operator=(Bvh&&) noexcept;

  /// Nothing where no triangle is nearer than `within_mm`.
  /// thread  any; allocates nothing
  std::optional<NearestPoint> nearest(
      const Vec3& point_mm,
      double within_mm = std::numeric_limits<double>::infinity()) const noexcept;
  /// Nearer than this no triangle is, and where it is above 0 the point lies outside [mm].
  /// thread  any; allocates nothing
  double outside_box_mm(const Vec3& point_mm) const noexcept;
  /// Negative inside [mm]. Where no surface is within `within_mm` the sign still holds and the size
  /// is `within_mm`.
  double signed_distance_mm(
      const Vec3& point_mm,
      double within_mm = std::numeric_limits<double>::infinity()) const noexcept;
  /// By the parity of crossings; agrees with the sign of the distance except on the surface.
  bool contains(const Vec3& point_mm) const noexcept;
  /// needs   direction has length 1
  std::optional<RayHit> first_hit(const Vec3& origin_mm, const Vec3& direction) const noexcept;
  /// Calls visit(NearTriangle) for triangles that may be nearer than `within_mm`, the nearer boxes
  /// first; the answer is the distance within which to go on [mm], negative to stop. The visit may
  /// not throw.
  template <typename Visit>
  void visit_near(const Vec3& point_mm, double within_mm, Visit&& visit) const noexcept {
    visit_near(
        point_mm, within_mm,
        [](void* context, const NearTriangle& found) noexcept -> double {
          return (*static_cast<std::remove_reference_t<Visit>*>(context))(found);
        },
        &visit);
  }
  /// Calls visit(triangle, corner_mm) for triangles that may come within `radius_mm` of the endless
  /// line through the point.
  /// needs   direction has length 1
  template <typename Visit>
  void visit_line(const Vec3& point_mm, const Vec3& direction, double radius_mm,
                  Visit&& visit) const {
    visit_line(
        point_mm, direction, radius_mm,
        [](void* context, std::uint32_t triangle, const std::array<Vec3, 3>& corner_mm) {
          (*static_cast<std::remove_reference_t<Visit>*>(context))(triangle, corner_mm);
        },
        &visit);
  }
  /// Replaces `triangles` by those that reach into |normal . p - offset| <= half_mm, in ascending
  /// order.
  void triangles_in_slab(const Vec3& normal, double offset_mm, double half_mm,
                         std::vector<std::uint32_t>& triangles) const;

 private:
  struct Tree;
  using NearVisit = double (*)(void* context, const NearTriangle& found);
  void visit_near(const Vec3& point_mm, double within_mm, NearVisit visit,
                  void* context) const noexcept;
  using LineVisit = void (*)(void* context, std::uint32_t triangle,
                             const std::array<Vec3, 3>& corner_mm);
  void visit_line(const Vec3& point_mm, const Vec3& direction, double radius_mm, LineVisit visit,
                  void* context) const;

  std::unique_ptr<const Tree> tree_;
};

}  // namespace hallux::simulator
