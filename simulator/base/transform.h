/// Rigid transforms between frames, named `to_from_from`: bone_from_tool = bone_from_world *
/// world_from_tool.
#pragma once

#include "simulator/base/vector.h"

namespace hallux {

struct RigidTransform {
  /// Unit length.
  Quat rotation{1.0, 0.0, 0.0, 0.0};
  Vec3 translation_mm{0.0, 0.0, 0.0};

  friend bool operator==(const RigidTransform&, const RigidTransform&) = default;
};

/// The direction `d` of the right-hand frame, said in the left-hand frame; its length stays.
inline Vec3 transform_direction(const RigidTransform& to_from_from,
                                const Vec3& direction) noexcept {
  const Quat& q = to_from_from.rotation;
  const Vec3 axis{q.x, q.y, q.z};
  const Vec3 turn = 2.0 * glm::cross(axis, direction);
  return direction + q.w * turn + glm::cross(axis, turn);
}
/// The point `p` of the right-hand frame, said in the left-hand frame [mm].
inline Vec3 transform_point(const RigidTransform& to_from_from, const Vec3& point_mm) noexcept {
  return transform_direction(to_from_from, point_mm) + to_from_from.translation_mm;
}
RigidTransform operator*(const RigidTransform& a_from_b, const RigidTransform& b_from_c) noexcept;
RigidTransform inverse(const RigidTransform& a_from_b) noexcept;
/// The right-hand frame's axes, said in the left-hand frame.
inline Vec3 axis_x(const RigidTransform& to_from_from) noexcept {
  return transform_direction(to_from_from, Vec3{1.0, 0.0, 0.0});
}
inline Vec3 axis_y(const RigidTransform& to_from_from) noexcept {
  return transform_direction(to_from_from, Vec3{0.0, 1.0, 0.0});
}
inline Vec3 axis_z(const RigidTransform& to_from_from) noexcept {
  return transform_direction(to_from_from, Vec3{0.0, 0.0, 1.0});
}
/// The pose a share of the way from one to the other: translations linear, rotations by their
/// normalised sum.
RigidTransform interpolate(const RigidTransform& from, const RigidTransform& to,
                           double share) noexcept;

/// The rotation that takes x to `x_axis` and keeps y as near to `y_hint` as it can.
/// needs   x_axis and y_hint are not parallel and not zero
Quat rotation_from_axes(const Vec3& x_axis, const Vec3& y_hint) noexcept;
/// The rotation about the unit vector `axis`; uses elementary.h, so it is the same on every
/// machine.
Quat rotation_about(const Vec3& axis, double angle_rad) noexcept;
/// The turn about the line through `point_mm` along the unit vector `axis`.
RigidTransform turn_about(const Vec3& point_mm, const Vec3& axis, double angle_rad) noexcept;
/// A quaternion of length 1 along `rotation`; the identity where the length is 0 or not finite.
Quat normalised(const Quat& rotation) noexcept;

}  // namespace hallux
