#include "simulator/bone/blade_sweep.h"

#include <cmath>

namespace hallux::simulator {

namespace {

/// A turning blade is followed in steps: the hull of two far turned blades is more than what lies
/// between them.
constexpr double turn_step = 0.02;

PlanarPose projected(const RigidTransform& kerf_from_mesh, const SweepPose& pose) {
  const Vec3 tip_mm = transform_point(kerf_from_mesh, pose.tip_in_mesh_mm);
  const Vec3 direction = transform_direction(kerf_from_mesh, pose.direction);
  const double length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  return {Vec2(tip_mm.x, tip_mm.y), Vec2(direction.x / length, direction.y / length)};
}

PlanarPose between(const PlanarPose& from, const PlanarPose& to, double part) {
  const Vec2 direction = from.direction + part * (to.direction - from.direction);
  return {from.tip_mm + part * (to.tip_mm - from.tip_mm),
          direction / std::sqrt(glm::dot(direction, direction))};
}

}  // namespace

BladePath path_in_plane(const Sweep& sweep, const KerfPlane& kerf) {
  const RigidTransform kerf_from_mesh = inverse(kerf.bone_from_kerf);
  BladePath path{{sweep.width_mm, sweep.depth_mm, kerf.thickness_mm}, {}};
  for (const SweepPose& pose : sweep.poses) path.poses.push_back(projected(kerf_from_mesh, pose));
  return path;
}

void stamp_motion(KerfField& field, const Blade& blade, const PlanarPose& from,
                  const PlanarPose& to) {
  FieldWindow changed;
  const Vec2 turn = to.direction - from.direction;
  const bool turns_back = glm::dot(from.direction, to.direction) < -0.99;
  const int steps =
      turns_back ? 1 : 1 + static_cast<int>(std::sqrt(glm::dot(turn, turn)) / turn_step);
  for (int i = 0; i < steps; ++i) {
    const PlanarPose start = i == 0 ? from : between(from, to, static_cast<double>(i) / steps);
    const PlanarPose end =
        i + 1 == steps ? to : between(from, to, static_cast<double>(i + 1) / steps);
    field.stamp(blade, start, end, changed);
  }
}

}  // namespace hallux::simulator
