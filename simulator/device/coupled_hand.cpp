#include "simulator/device/coupled_hand.h"

#include <algorithm>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

constexpr double mm_per_m = 1000.0;
/// A device that was not asked for longer goes on from where it was.
constexpr std::int64_t ticks_at_most = 3;

}  // namespace

/// Semi-implicit Euler: the velocity first, then the way with the new velocity.
void CoupledHand::follow(const RigidTransform& world_from_target, const Vec3& unyielding_in_world,
                         const Vec3& force_in_world_newton) noexcept {
  const Vec3 ahead_mm = world_from_target.translation_mm - world_from_hand_.translation_mm;
  const Vec3 sum_newton = coupling_.stiffness_newton_per_mm * ahead_mm -
                          coupling_.damping_newton_s_per_mm * velocity_mm_s_ +
                          force_in_world_newton;
  velocity_mm_s_ += step_s * mm_per_m / coupling_.mass_kg * sum_newton;
  const double speed_mm_s = length_of(velocity_mm_s_);
  if (speed_mm_s > coupling_.speed_limit_mm_s) {
    velocity_mm_s_ *= coupling_.speed_limit_mm_s / speed_mm_s;
  }
  world_from_hand_.translation_mm += step_s * velocity_mm_s_;
  const Vec3& along = unyielding_in_world;
  const Vec3 off_mm = world_from_target.translation_mm - world_from_hand_.translation_mm;
  world_from_hand_.translation_mm += glm::dot(along, off_mm) * along;
  velocity_mm_s_ -= glm::dot(along, velocity_mm_s_) * along;
  world_from_hand_.rotation =
      interpolate(world_from_hand_, world_from_target, step_s / coupling_.turn_s).rotation;
}

std::int64_t ticks_to_follow(std::int64_t tick, std::int64_t last_tick) noexcept {
  return last_tick < 0 ? 1 : std::clamp<std::int64_t>(tick - last_tick, 1, ticks_at_most);
}

}  // namespace hallux::simulator
