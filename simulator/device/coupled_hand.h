/// A hand of some mass that follows a target through a spring and a damper, and feels the simulated
/// force: what stands between a device that pushes nobody back and the saw.
/// Inside this corner only.
///
///     target --spring, damper--> hand of 0.15 kg
///                                 ^ simulated force
///
/// Bone stops the hand and the target runs ahead: how far it is ahead is how hard one pushes.
#pragma once

#include <cstdint>

#include "simulator/base/transform.h"

namespace hallux::simulator {

/// source  docs/haptics.md, The mouse
struct HandCoupling {
  double stiffness_newton_per_mm = 1.0;
  double mass_kg = 0.15;
  /// Critical: 2 sqrt(stiffness x mass).
  double damping_newton_s_per_mm = 0.0245;
  double speed_limit_mm_s = 800.0;
  /// In which a turn of the target is followed to 63 %.
  double turn_s = 0.03;
};

class CoupledHand {
 public:
  explicit CoupledHand(const RigidTransform& world_from_hand, const HandCoupling& coupling = {})
      : coupling_(coupling), world_from_hand_(world_from_hand) {}

  const RigidTransform& world_from_hand() const noexcept { return world_from_hand_; }

  /// One tick.
  /// unyielding_in_world  a unit direction along which the hand is as the target is, whatever
  ///                      pushes it; zero: it yields to all sides
  void follow(const RigidTransform& world_from_target, const Vec3& unyielding_in_world,
              const Vec3& force_in_world_newton) noexcept;

 private:
  HandCoupling coupling_;
  RigidTransform world_from_hand_;
  Vec3 velocity_mm_s_{0.0, 0.0, 0.0};
};

/// How many ticks a device goes on from where it was, asked at `tick` after `last_tick`; at most
/// three, one at first (`last_tick` below 0).
std::int64_t ticks_to_follow(std::int64_t tick, std::int64_t last_tick) noexcept;

}  // namespace hallux::simulator
