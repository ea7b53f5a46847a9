#include "simulator/base/transform.h"

#include <cmath>

#include "simulator/base/elementary.h"

namespace hallux {

RigidTransform operator*(const RigidTransform& a_from_b, const RigidTransform& b_from_c) noexcept {
  return {a_from_b.rotation * b_from_c.rotation,
          transform_point(a_from_b, b_from_c.translation_mm)};
}

RigidTransform inverse(const RigidTransform& a_from_b) noexcept {
  RigidTransform b_from_a{glm::conjugate(a_from_b.rotation), Vec3{0.0, 0.0, 0.0}};
  b_from_a.translation_mm = -transform_direction(b_from_a, a_from_b.translation_mm);
  return b_from_a;
}

Quat normalised(const Quat& rotation) noexcept {
  const double length = std::sqrt(rotation.w * rotation.w + rotation.x * rotation.x +
                                  rotation.y * rotation.y + rotation.z * rotation.z);
  if (!(length > 0.0) || !std::isfinite(length)) return Quat{1.0, 0.0, 0.0, 0.0};
  return Quat{rotation.w / length, rotation.x / length, rotation.y / length, rotation.z / length};
}

RigidTransform interpolate(const RigidTransform& from, const RigidTransform& to,
                           double share) noexcept {
  const double sign = glm::dot(from.rotation, to.rotation) < 0.0 ? -1.0 : 1.0;
  return {normalised(from.rotation * (1.0 - share) + to.rotation * (sign * share)),
          from.translation_mm + share * (to.translation_mm - from.translation_mm)};
}

namespace {

/// Shepperd's choice of the largest component keeps the square root away from zero.
Quat quaternion_from_columns(const Vec3& x, const Vec3& y, const Vec3& z) noexcept {
  const double trace = x.x + y.y + z.z;
  if (trace > 0.0) return {1.0 + trace, y.z - z.y, z.x - x.z, x.y - y.x};
  if (x.x >= y.y && x.x >= z.z) return {y.z - z.y, 1.0 + x.x - y.y - z.z, y.x + x.y, z.x + x.z};
  if (y.y >= z.z) return {z.x - x.z, y.x + x.y, 1.0 + y.y - x.x - z.z, z.y + y.z};
  return {x.y - y.x, z.x + x.z, z.y + y.z, 1.0 + z.z - x.x - y.y};
}

}  // namespace

Quat rotation_from_axes(const Vec3& x_axis, const Vec3& y_hint) noexcept {
  const Vec3 x = unit(x_axis);
  const Vec3 z = unit(glm::cross(x, y_hint));
  return normalised(quaternion_from_columns(x, glm::cross(z, x), z));
}

Quat rotation_about(const Vec3& axis, double angle_rad) noexcept {
  const double s = elementary::sin(0.5 * angle_rad);
  return normalised(Quat{elementary::cos(0.5 * angle_rad), s * axis.x, s * axis.y, s * axis.z});
}

RigidTransform turn_about(const Vec3& point_mm, const Vec3& axis, double angle_rad) noexcept {
  const RigidTransform turn{rotation_about(axis, angle_rad), {}};
  return {turn.rotation, point_mm - transform_direction(turn, point_mm)};
}

}  // namespace hallux
