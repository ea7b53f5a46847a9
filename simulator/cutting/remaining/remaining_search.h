/// One search for the nearest standing surface. Inside this corner only.
#pragma once

#include <array>
#include <optional>

#include "simulator/cutting/field/field_rim.h"
#include "simulator/cutting/remaining/remaining_bone.h"

namespace hallux::simulator {

class RemainingSearch {
 public:
  RemainingSearch(const RemainingBone& bone, const Vec3& point_mm, double within_mm) noexcept;

  std::optional<RemainingPoint> run() noexcept;

 private:
  /// A kerf as the search sees it.
  struct Slab {
    Vec3 axis_x{0.0, 0.0, 0.0}, axis_y{0.0, 0.0, 0.0}, axis_z{0.0, 0.0, 0.0},
        origin_mm{0.0, 0.0, 0.0};
    double half_mm = 0.0;
    /// The point asked about, in the kerf's frame.
    Vec3 local_mm{0.0, 0.0, 0.0};

    Vec3 to_local(const Vec3& point_mm) const noexcept {
      const Vec3 arm = point_mm - origin_mm;
      return {glm::dot(axis_x, arm), glm::dot(axis_y, arm), glm::dot(axis_z, arm)};
    }
    Vec3 to_bone(const Vec3& local) const noexcept {
      return origin_mm + local.x * axis_x + local.y * axis_y + local.z * axis_z;
    }
    double height_mm(const Vec3& point_mm) const noexcept {
      return glm::dot(axis_z, point_mm - origin_mm);
    }
  };
  /// A convex part of a triangle: each kerf adds at most two corners.
  struct Polygon {
    std::array<Vec3, 3 + 2 * static_cast<std::size_t>(kerf_limit)> corner_mm;
    std::size_t count = 0;
  };
  /// No bone of the original within this ball.
  struct Barren {
    Vec3 centre_mm{0.0, 0.0, 0.0};
    double radius_mm = 0.0;
  };

  /// On the upright face over a segment of the rim, in the kerf's frame.
  struct FrontPoint {
    Vec3 local_mm{0.0, 0.0, 0.0};
    /// Into the bone.
    Vec3 outward{0.0, 0.0, 0.0};
  };

  const KerfField& field(std::int32_t kerf) const noexcept { return bone_.kerfs.field(kerf); }
  const Slab& slab(std::int32_t kerf) const noexcept {
    return slabs_[static_cast<std::size_t>(kerf)];
  }

  bool is_open(std::int32_t kerf, const Vec3& point_mm, double margin_mm) const noexcept;
  bool is_open_elsewhere(std::int32_t but_kerf, const Vec3& point_mm) const noexcept;
  bool stands(const Vec3& behind_mm, std::int32_t but_kerf) const noexcept;
  bool skin_stands(const Vec3& on_skin_mm) const noexcept;
  void offer(RemainingPoint found) noexcept;

  void try_walls(std::int32_t kerf) noexcept;
  void try_skin() noexcept;
  void try_triangle(const NearTriangle& found) noexcept;
  void try_polygon(const Polygon& polygon, KerfNumbers::Iterator kerf,
                   const NearTriangle& of) noexcept;
  void offer_skin(const Vec3& on_skin_mm, const NearTriangle& of) noexcept;
  static Polygon clipped(const Polygon& polygon, const Slab& slab, double side,
                         double level_mm) noexcept;

  void try_rim(std::int32_t kerf) noexcept;
  void try_segment(std::int32_t kerf, const RimSegment& segment) noexcept;
  void try_along(std::int32_t kerf, const FrontPoint& from, const Vec3& direction,
                 double room_mm) noexcept;
  void offer_front(std::int32_t kerf, const FrontPoint& front) noexcept;
  bool is_barren(const Slab& slab, const RimSegment& segment) const noexcept;
  void try_lines(std::int32_t first, std::int32_t second) noexcept;

  const RemainingBone& bone_;
  const KerfNumbers kerfs_;
  Vec3 point_mm_;
  double within_mm_;
  std::optional<RemainingPoint> best_;
  std::array<Slab, static_cast<std::size_t>(kerf_limit)> slabs_;
  /// Around the point asked about; around the last rim that was in the air.
  std::array<Barren, 2> barren_;
};

}  // namespace hallux::simulator
