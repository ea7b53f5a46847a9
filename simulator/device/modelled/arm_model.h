/// A haptic arm as a mass on a damper, with encoders and a delay: what stands for the hardware in
/// virtual time. Inside this corner only.
///
///     force sent --transport ticks--> motors, at most so strong --> mass <-- hand
///                            place that is read <-- encoder steps <--'
#pragma once

#include <array>
#include <cstdint>

#include "simulator/base/vector.h"
#include "simulator/device/device_limits.h"

namespace hallux::simulator {

/// source  docs/haptics.md, The modelled arm
struct ArmTraits {
  double mass_kg = 0.15;
  double damping_newton_s_per_mm = 0.002;
  double encoder_step_mm = 0.015;
  double motor_limit_newton = 8.0;
  /// From 0 to 3.
  std::int32_t transport_ticks = 1;
  /// Of a tick: the arm itself knows no ticks.
  std::int32_t substeps = 10;
};

/// Work done since the beginning [mJ]; positive where the handle received it.
struct ArmWork {
  double of_motors_millijoule = 0.0;
  double of_hand_millijoule = 0.0;
};

struct ArmState {
  Vec3 place_mm{0.0, 0.0, 0.0};
  Vec3 velocity_mm_s{0.0, 0.0, 0.0};
  /// Sent and not yet acting, the newest first; what acts lies at the transport's ticks.
  std::array<Vec3, transport_ticks_at_most + 1> sent_newton{};
  ArmWork work;
};

/// The force of a hand on the handle, as a spring and a damper to where it wants to be.
struct HandGrip {
  double stiffness_newton_per_mm = 0.3;
  double damping_newton_s_per_mm = 0.003;
  Vec3 wanted_mm{0.0, 0.0, 0.0};
  /// Besides.
  Vec3 push_newton{0.0, 0.0, 0.0};
};

/// The force sent at this tick; it begins to act after the transport. A device that was told
/// nothing new sends on what it was told.
/// needs   0 <= transport_ticks <= 3
void send_force(ArmState& arm, const Vec3& force_newton) noexcept;

/// One millisecond, by semi-implicit Euler: the velocity first, then the way with the new velocity.
/// needs   substeps > 0, mass above 0
void advance(ArmState& arm, const ArmTraits& traits, const HandGrip& hand) noexcept;

/// What the encoders say: the place, in whole steps.
Vec3 read_encoders(const ArmState& arm, const ArmTraits& traits) noexcept;

}  // namespace hallux::simulator
