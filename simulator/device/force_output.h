/// From the simulated force to what the device is given, one tick at a time.
///
///     simulated force -> x scale -> x soft start -> kept passive -> + tremble
///                     |     -> at most force and heat allow -> slew -> device
///                     '- fault, pause, faster than a hand: zero at once, and a soft start after
///
/// Total and deterministic, of its state and input alone. What is recorded and scored is the
/// simulated force; this is what an arm can bear of it.
#pragma once

#include <cstdint>

#include "simulator/base/bits.h"
#include "simulator/device/device_limits.h"
#include "simulator/device/passivity.h"
#include "simulator/device/thermal_budget.h"

namespace hallux::simulator {

/// What made the device's force another than scale x simulated.
enum class ForceLimit : std::uint32_t {
  /// A fault, a pause, or no number: no force.
  Stopped = 1U << 0U,
  /// The handle is faster than a hand: no force.
  TooFast = 1U << 1U,
  /// It grows since the last stop.
  SoftStart = 1U << 2U,
  /// Damped, because more energy would come back than was put in.
  Passivity = 1U << 3U,
  /// What the motors bear.
  Heat = 1U << 4U,
  /// What the device gives.
  Greatest = 1U << 5U,
  /// As fast as it may change.
  Slew = 1U << 6U
};

struct ForceOutputSettings {
  /// Device newtons per simulated newton.
  double scale = 1.0;
  double force_newton = 0.0;
  double slew_newton_per_s = 500.0;
  double soft_start_s = 0.5;
  double speed_limit_mm_s = 1000.0;
  PassivitySettings passivity;
  ThermalSettings thermal;
};

/// For a device with these limits and a contact whose force is a spring of that stiffness,
/// simulated. `exchanges_until_sent` lie between a force and the one that carries it to the device,
/// 0 or 1; its transport comes on top.
/// needs   limits that are possible: every one of them above 0, damping at least 0
ForceOutputSettings force_output_settings(const DeviceLimits& limits,
                                          double simulated_spring_newton_per_mm,
                                          std::int32_t exchanges_until_sent) noexcept;

struct ForceInput {
  /// On the hand.
  Vec3 simulated_in_world_newton{0.0, 0.0, 0.0};
  /// At this tick, as the device said it.
  Vec3 handle_in_world_mm{0.0, 0.0, 0.0};
  /// Open loop, in newtons of the device: softly started and limited like the rest, but no matter
  /// of passivity.
  Vec3 vibration_in_world_newton{0.0, 0.0, 0.0};
  /// Since the tick before.
  double duration_s = 0.001;
  /// Neither fault nor pause.
  bool is_live = true;
};

struct ForceOutputState {
  /// Of the soft start, [0, 1].
  double started_share = 0.0;
  Vec3 handle_in_world_mm{0.0, 0.0, 0.0};
  /// Since the last stop.
  bool has_handle = false;
  Vec3 sent_newton{0.0, 0.0, 0.0};
  EnergyAccount account;
  ThermalBudget thermal;
};

struct DeviceForce {
  Vec3 force_in_world_newton{0.0, 0.0, 0.0};
  /// Bits of ForceLimit.
  std::uint32_t limits = 0;
};

/// The force [N] for the device at this tick.
/// ensures |force| <= force_newton and the heat <= 1; zero where the input is not live or no
///         number; changes by at most the slew otherwise, and what the heat takes
/// errors  none: total, allocates nothing
/// thread  haptic
DeviceForce output_force(ForceOutputState& state, const ForceOutputSettings& settings,
                         const ForceInput& input) noexcept;

}  // namespace hallux::simulator
