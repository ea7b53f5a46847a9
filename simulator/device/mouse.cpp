#include "simulator/device/mouse.h"

namespace hallux::simulator {

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

MouseDevice::MouseDevice(const RigidTransform& world_from_start, const HandCoupling& coupling)
    : hand_(world_from_start, coupling), target_({{world_from_start, 0, {}}, 0}) {}

void MouseDevice::aim(const Aim& aim) noexcept { target_.write({aim, ++aims_}); }

bool MouseDevice::exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                           RawDeviceState& state) noexcept {
  const auto& [aim, number] = target_.read();
  if (number != heard_) heard_tick_ = tick;
  heard_ = number;
  const std::int64_t ticks = ticks_to_follow(tick, tick_);
  tick_ = tick;
  for (std::int64_t i = 0; i < ticks; ++i) {
    hand_.follow(aim.world_from_target, aim.unyielding_in_world, force_in_world_newton);
  }
  state = {hand_.world_from_hand(), tick - heard_tick_ > silence_ticks ? 0U : aim.switches};
  return true;
}

}  // namespace hallux::simulator
