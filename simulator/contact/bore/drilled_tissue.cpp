#include "simulator/contact/bore/drilled_tissue.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

namespace {

/// Nearer than this the way to a surface is no direction.
constexpr double direction_mm = 1.0e-5;
/// How deep a ball may be in bone and still be led out.
constexpr double way_out_mm = 1.0;

/// The hole, of those of at least this radius, in which the point is deepest, or whose wall it is
/// nearest to.
struct NearHole {
  const Capsule* hole = nullptr;
  /// From its wall, negative inside.
  double distance_mm = 1.0e9;
};

NearHole nearest_hole(std::span<const Capsule> holes, const Vec3& point_mm,
                      double radius_mm) noexcept {
  NearHole nearest;
  for (const Capsule& hole : holes) {
    if (hole.radius_mm < radius_mm) continue;
    const double away_mm = distance_mm(hole, point_mm);
    if (away_mm < nearest.distance_mm) nearest = {&hole, away_mm};
  }
  return nearest;
}

/// The wall of a hole for a point in it or in the bone beside it.
std::optional<BallSurface> wall_of(const NearHole& near, const Vec3& point_mm,
                                   double within_mm) noexcept {
  if (-near.distance_mm > within_mm) return std::nullopt;
  const Vec3 inward = closest_on_segment(axis_of(*near.hole), point_mm) - point_mm;
  const double length_mm = length_of(inward);
  if (length_mm < direction_mm) return std::nullopt;
  return BallSurface{inward / length_mm, -near.distance_mm};
}

BallSurface surface_at(const RemainingPoint& found, const Vec3& point_mm, double side) noexcept {
  const double height_mm = side * found.distance_mm;
  if (found.distance_mm < direction_mm) return {found.normal, height_mm};
  return {(side / found.distance_mm) * (point_mm - found.point_in_bone_mm), height_mm};
}

}  // namespace

Tissue DrilledTissue::at(const Vec3& point_in_body_mm, TissueMemory& memory) const noexcept {
  if (is_in_capsule(holes, point_in_body_mm)) return Tissue::None;
  return bone.at(point_in_body_mm, memory);
}

Tissue DrilledTissue::at(const Vec3& point_in_body_mm) const noexcept {
  TissueMemory nothing;
  return at(point_in_body_mm, nothing);
}

std::optional<BallSurface> DrilledTissue::near_ball(const ToolBall& ball, double within_mm,
                                                    BallMemory& memory) const noexcept {
  const Vec3& centre_mm = ball.centre_in_body_mm;
  SurfaceMemory& known = memory.surface;
  const double moved_mm = length_of(centre_mm - known.asked_mm);
  if (known.is_known && known.clearance_mm - moved_mm > within_mm) return std::nullopt;
  const bool is_inside = bone.at(centre_mm, memory.tissue) != Tissue::None;
  const NearHole hole = nearest_hole(holes, centre_mm, ball.needs_mm);
  if (is_inside && hole.distance_mm < 0.0) return wall_of(hole, centre_mm, within_mm);
  const double reach_mm = is_inside ? way_out_mm : within_mm;
  const std::optional<RemainingPoint> found = bone.remaining().nearest(centre_mm, reach_mm);
  if (is_inside) {
    known.is_known = false;
    const double skin_mm = found ? found->distance_mm : way_out_mm;
    if (hole.distance_mm < skin_mm) return wall_of(hole, centre_mm, within_mm);
    if (!found) return std::nullopt;
    return surface_at(*found, centre_mm, -1.0);
  }
  known = {centre_mm, found ? found->distance_mm : reach_mm, true};
  if (!found) return std::nullopt;
  const NearHole mouth = nearest_hole(holes, found->point_in_bone_mm, ball.needs_mm);
  if (mouth.distance_mm < 0.0) return std::nullopt;
  return surface_at(*found, centre_mm, 1.0);
}

}  // namespace hallux::simulator
