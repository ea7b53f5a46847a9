#include "simulator/cutting/hole/bore.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

/// Axes this near to each other are one: more than what a pose is rounded by over the longest wire.
constexpr double same_axis_sine = 1.0e-4, same_axis_mm = 0.02;

}  // namespace

Bore begin_bore(const RigidTransform& body_from_tool, double touch_depth_mm,
                double radius_mm) noexcept {
  RigidTransform body_from_bore = body_from_tool;
  body_from_bore.translation_mm -= touch_depth_mm * axis_x(body_from_tool);
  return {body_from_bore, radius_mm, touch_depth_mm};
}

Bore widened(const Bore& bore, double radius_mm) noexcept {
  return {bore.body_from_bore, radius_mm, 0.0};
}

void open_bore(Bore& bore, const RigidTransform& body_from_tool) noexcept {
  bore.depth_mm = std::max(bore.depth_mm, way_along(bore, body_from_tool.translation_mm));
}

bool is_along(const RigidTransform& axis, const RigidTransform& other) noexcept {
  const Vec3 x = axis_x(axis);
  if (glm::dot(x, axis_x(other)) <= 0.0) return false;
  const Vec3 arm = other.translation_mm - axis.translation_mm;
  return length_of(glm::cross(x, axis_x(other))) <= same_axis_sine &&
         length_of(arm - glm::dot(arm, x) * x) <= same_axis_mm;
}

double way_along(const Bore& bore, const Vec3& point_in_body_mm) noexcept {
  return glm::dot(axis_x(bore.body_from_bore),
                  point_in_body_mm - bore.body_from_bore.translation_mm);
}

Capsule capsule_of(const Bore& bore) noexcept {
  // The half ball at the end is the point: the tip, and no more, was at the depth.
  const Vec3 x = axis_x(bore.body_from_bore);
  const double end_mm = std::max(bore.depth_mm - bore.radius_mm, -bore.radius_mm);
  return {bore.body_from_bore.translation_mm - bore.radius_mm * x,
          bore.body_from_bore.translation_mm + end_mm * x, bore.radius_mm};
}

}  // namespace hallux::simulator
