#include "simulator/device/mouse.h"

#include <algorithm>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

constexpr double mm_per_m = 1000.0;
/// A device that was not asked for longer goes on from where it was.
constexpr std::int64_t ticks_at_most = 3;

}  // namespace

RigidTransform steered(const RigidTransform& world_from_target, const Quat& world_from_view,
                       const PointerMotion& motion) {
  const double share = motion.is_fine ? fine_share : 1.0;
  const auto in_world = [&](const Vec3& in_view) { return world_from_view * in_view; };
  RigidTransform moved = world_from_target;
  moved.translation_mm +=
      in_world(share * Vec3(motion.across_mm.x, motion.across_mm.y, -motion.deeper_mm)) +
      share * motion.pushed_mm * axis_x(world_from_target);
  const Quat turn = rotation_about(in_world(Vec3(0.0, 1.0, 0.0)), share * motion.turned_rad.x) *
                    rotation_about(in_world(Vec3(1.0, 0.0, 0.0)), -share * motion.turned_rad.y) *
                    rotation_about(in_world(Vec3(0.0, 0.0, 1.0)), share * motion.rolled_rad);
  moved.rotation = normalised(turn * moved.rotation);
  return moved;
}

RigidTransform kept_within(const RigidTransform& world_from_target, const Vec3& middle_in_world_mm,
                           double radius_mm) noexcept {
  RigidTransform kept = world_from_target;
  const Vec3 away_mm = kept.translation_mm - middle_in_world_mm;
  const double distance_mm = length_of(away_mm);
  if (distance_mm > radius_mm) {
    kept.translation_mm = middle_in_world_mm + radius_mm / distance_mm * away_mm;
  }
  return kept;
}

MouseDevice::MouseDevice(const RigidTransform& world_from_start, const MouseCoupling& coupling)
    : coupling_(coupling),
      target_({{world_from_start, 0, {}}, 0}),
      world_from_hand_(world_from_start) {}

void MouseDevice::aim(const Aim& aim) noexcept { target_.write({aim, ++aims_}); }

bool MouseDevice::exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                           RawDeviceState& state) noexcept {
  const auto& [aim, number] = target_.read();
  if (number != heard_) heard_tick_ = tick;
  heard_ = number;
  const std::int64_t ticks =
      tick_ < 0 ? 1 : std::clamp<std::int64_t>(tick - tick_, 1, ticks_at_most);
  tick_ = tick;
  for (std::int64_t i = 0; i < ticks; ++i) pull_towards(aim, force_in_world_newton);
  state = {world_from_hand_, tick - heard_tick_ > silence_ticks ? 0U : aim.switches};
  return true;
}

/// Semi-implicit Euler: the velocity first, then the way with the new velocity.
void MouseDevice::pull_towards(const Aim& aim, const Vec3& force_newton) noexcept {
  const RigidTransform& world_from_target = aim.world_from_target;
  const Vec3 ahead_mm = world_from_target.translation_mm - world_from_hand_.translation_mm;
  const Vec3 sum_newton = coupling_.stiffness_newton_per_mm * ahead_mm -
                          coupling_.damping_newton_s_per_mm * velocity_mm_s_ + force_newton;
  velocity_mm_s_ += step_s * mm_per_m / coupling_.mass_kg * sum_newton;
  const double speed_mm_s = length_of(velocity_mm_s_);
  if (speed_mm_s > coupling_.speed_limit_mm_s) {
    velocity_mm_s_ *= coupling_.speed_limit_mm_s / speed_mm_s;
  }
  world_from_hand_.translation_mm += step_s * velocity_mm_s_;
  const Vec3& along = aim.unyielding_in_world;
  const Vec3 off_mm = world_from_target.translation_mm - world_from_hand_.translation_mm;
  world_from_hand_.translation_mm += glm::dot(along, off_mm) * along;
  velocity_mm_s_ -= glm::dot(along, velocity_mm_s_) * along;
  world_from_hand_.rotation =
      interpolate(world_from_hand_, world_from_target, step_s / coupling_.turn_s).rotation;
}

}  // namespace hallux::simulator
