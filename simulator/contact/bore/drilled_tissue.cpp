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
  const Vec3& centre_mm = ball.centre_mm;
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

Tissue DrilledWound::at(const Vec3& point_in_wound_mm,
                        OfFragments<TissueMemory>& memory) const noexcept {
  Tissue hardest = Tissue::None;
  wound.visit_near(point_in_wound_mm, 0.0, [&](std::int32_t number, const WoundFragment& standing) {
    hardest = std::max(hardest, drilled(number, standing)
                                    .at(standing.point_from(point_in_wound_mm),
                                        memory[static_cast<std::size_t>(number)]));
  });
  return hardest;
}

Tissue DrilledWound::at(const Vec3& point_in_wound_mm) const noexcept {
  OfFragments<TissueMemory> nothing;
  return at(point_in_wound_mm, nothing);
}

Tissue DrilledWound::undrilled_at(const Vec3& point_in_wound_mm) const noexcept {
  const HolesOfFragments none;
  return DrilledWound{wound, none}.at(point_in_wound_mm);
}

std::optional<BallSurface> DrilledWound::near_ball(const ToolBall& ball, double within_mm,
                                                   OfFragments<BallMemory>& memory) const noexcept {
  std::optional<BallSurface> nearest;
  const auto ask = [&](std::int32_t number, const WoundFragment& standing) {
    const ToolBall asked{standing.point_from(ball.centre_mm), ball.needs_mm};
    std::optional<BallSurface> found =
        drilled(number, standing)
            .near_ball(asked, within_mm, memory[static_cast<std::size_t>(number)]);
    if (!found || (nearest && nearest->height_mm <= found->height_mm)) return;
    if (standing.is_moved)
      found->normal = transform_direction(standing.wound_from_fragment, found->normal);
    nearest = found;
  };
  wound.visit_near(ball.centre_mm, within_mm, ask);
  return nearest;
}

bool DrilledWound::is_in_hole(const Vec3& point_in_wound_mm) const noexcept {
  bool is_in = false;
  wound.visit_near(point_in_wound_mm, 0.0, [&](std::int32_t number, const WoundFragment& standing) {
    is_in = is_in || is_in_capsule(holes[static_cast<std::size_t>(number)],
                                   standing.point_from(point_in_wound_mm));
  });
  return is_in;
}

std::int32_t DrilledWound::points_in_bone_of(
    std::int32_t number, std::span<const Vec3> points_in_wound_mm,
    std::span<OfFragments<TissueMemory>> memories) const noexcept {
  const WoundFragment& standing = *wound.fragment(number);
  const DrilledTissue tissue = drilled(number, standing);
  std::int32_t count = 0;
  for (std::size_t i = 0; i < points_in_wound_mm.size(); ++i) {
    TissueMemory& memory = memories[i][static_cast<std::size_t>(number)];
    if (is_bone(tissue.at(standing.point_from(points_in_wound_mm[i]), memory))) ++count;
  }
  return count;
}

}  // namespace hallux::simulator
