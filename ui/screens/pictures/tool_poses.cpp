#include "ui/screens/pictures/tool_poses.h"

#include <cmath>

namespace hallux::ui {

namespace {

/// So far out of a piece the points of the jaws stand.
constexpr double outside_mm = 1.0;
/// A wish that lies more along the direction than this says nothing.
constexpr double least_across = 0.1;

}  // namespace

RigidTransform pose_along(const Vec3& along, const Vec3& y_wish, const Vec3& origin_mm) noexcept {
  const bool is_told = length_of(glm::cross(along, y_wish)) > least_across;
  const Vec3 other = std::abs(along.x) < 0.9 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  return {rotation_from_axes(along, is_told ? y_wish : other), origin_mm};
}

std::optional<RigidTransform> jaws_around(const simulator::Bvh& piece,
                                          const RigidTransform& piece_from_hand) noexcept {
  const Vec3& hand_mm = piece_from_hand.translation_mm;
  const auto near = piece.nearest(hand_mm);
  if (!near) return std::nullopt;
  const Vec3 way_mm = near->point_mm - hand_mm;
  const Vec3 along = length_of(way_mm) > outside_mm ? unit(way_mm) : axis_x(piece_from_hand);
  return pose_along(along, axis_y(piece_from_hand), near->point_mm - outside_mm * along);
}

}  // namespace hallux::ui
