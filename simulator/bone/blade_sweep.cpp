#include "simulator/bone/blade_sweep.h"

namespace hallux::simulator {

namespace {

/// A turning blade is followed in steps: the hull of two far turned blades is more than what lies
/// between them.
constexpr double turn_step = 0.02;

PlanarPose projected(const RigidTransform& kerf_from_mesh, const SweepPose& pose) {
  const Vec3 tip_mm = transform_point(kerf_from_mesh, pose.tip_in_mesh_mm);
  const Vec3 direction = transform_direction(kerf_from_mesh, pose.direction);
  return {Vec2(tip_mm.x, tip_mm.y), unit(Vec2(direction.x, direction.y))};
}

PlanarPose between(const PlanarPose& from, const PlanarPose& to, double part) {
  return {from.tip_mm + part * (to.tip_mm - from.tip_mm),
          unit(from.direction + part * (to.direction - from.direction))};
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
  const bool turns_back = glm::dot(from.direction, to.direction) < -0.99;
  const double turn = length_of(to.direction - from.direction);
  const int steps = turns_back ? 1 : 1 + static_cast<int>(turn / turn_step);
  for (int i = 0; i < steps; ++i) {
    const PlanarPose start = i == 0 ? from : between(from, to, static_cast<double>(i) / steps);
    const PlanarPose end =
        i + 1 == steps ? to : between(from, to, static_cast<double>(i + 1) / steps);
    field.stamp(blade, start, end, changed);
  }
}

}  // namespace hallux::simulator
