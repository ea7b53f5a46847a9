#include "simulator/device/rail.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/elementary.h"

namespace hallux::simulator {

namespace {

constexpr double in_rail_mm = 1.0e-3, in_rail_rad = 1.0e-4;

double off_mm(const Rail& rail, const RigidTransform& pose) noexcept {
  return glm::dot(rail.normal_in_world, pose.translation_mm) - rail.offset_mm;
}

/// From the blade's normal to the rail's, the shorter way round; of sine length.
Vec3 turn_back(const Rail& rail, const RigidTransform& pose) noexcept {
  const Vec3 blade = axis_z(pose);
  const double side = glm::dot(blade, rail.normal_in_world) < 0.0 ? -1.0 : 1.0;
  return side * glm::cross(blade, rail.normal_in_world);
}

}  // namespace

RigidTransform railed(const RigidTransform& world_from_tool, const Rail& rail,
                      double duration_s) noexcept {
  RigidTransform pose = world_from_tool;
  const double off = off_mm(rail, pose), step_mm = rail_speed_mm_s * duration_s;
  pose.translation_mm -= std::clamp(off, -step_mm, step_mm) * rail.normal_in_world;
  const Vec3 way = turn_back(rail, pose);
  const double sine = length_of(way);
  if (sine > 0.0) {
    const double angle_rad = elementary::asin(std::min(1.0, sine));
    const double turn_rad = std::min(angle_rad, rail_turn_rad_s * duration_s);
    pose.rotation = normalised(rotation_about(way / sine, turn_rad) * pose.rotation);
  }
  return pose;
}

bool lies_in(const Rail& rail, const RigidTransform& world_from_tool) noexcept {
  return std::abs(off_mm(rail, world_from_tool)) < in_rail_mm &&
         length_of(turn_back(rail, world_from_tool)) < in_rail_rad;
}

}  // namespace hallux::simulator
