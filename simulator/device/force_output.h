/// From the simulated force to what the device is given, one tick at a time.
///
///     simulated force -> x scale -> x soft start -> kept passive -> + tremble -> at most force and heat allow -> slew -> device
///                     '- fault, pause, faster than a hand: zero at once, and a soft start afterwards
///
/// Total and deterministic, of its state and input alone. What is recorded and scored is the simulated force; this is what an
/// arm can bear of it.
#pragma once

#include <cstdint>

#include "simulator/device/device_limits.h"
#include "simulator/device/passivity.h"
#include "simulator/device/thermal_budget.h"

namespace hallux::simulator {

/// What made the device's force another than scale x simulated.
enum class ForceLimit : std::uint32_t {
  Stopped = 1U << 0U,    ///< a fault, a pause, or no number: no force
  TooFast = 1U << 1U,    ///< the handle is faster than a hand: no force
  SoftStart = 1U << 2U,  ///< it grows since the last stop
  Passivity = 1U << 3U,  ///< damped, because more energy would come back than was put in
  Heat = 1U << 4U,       ///< what the motors bear
  Greatest = 1U << 5U,   ///< what the device gives
  Slew = 1U << 6U        ///< as fast as it may change
};

constexpr bool has(std::uint32_t bits, ForceLimit bit) noexcept {
  return (bits & static_cast<std::uint32_t>(bit)) != 0;
}

struct ForceOutputSettings {
  double scale = 1.0;  ///< device newtons per simulated newton
  double force_newton = 0.0;
  double slew_newton_per_s = 500.0;
  double soft_start_s = 0.5;
  double speed_limit_mm_s = 1000.0;
  PassivitySettings passivity;
  ThermalSettings thermal;
};

/// For a device with these limits and a contact whose force is a spring of that stiffness, simulated.
/// `exchanges_until_sent` lie between a force and the one that carries it to the device, 0 or 1; its transport comes on top.
/// needs   limits that are possible: every one of them above 0, damping at least 0
ForceOutputSettings force_output_settings(const DeviceLimits& limits,
                                          double simulated_spring_newton_per_mm,
                                          std::int32_t exchanges_until_sent) noexcept;

struct ForceInput {
  Vec3 simulated_in_world_newton{0.0, 0.0, 0.0};  ///< on the hand
  Vec3 handle_in_world_mm{0.0, 0.0, 0.0};         ///< at this tick, as the device said it
  /// Open loop, in newtons of the device: softly started and limited like the rest, but no matter of passivity.
  Vec3 tremble_in_world_newton{0.0, 0.0, 0.0};
  double duration_s = 0.001;  ///< since the tick before
  bool is_live = true;        ///< neither fault nor pause
};

struct ForceOutputState {
  double started_share = 0.0;  ///< of the soft start, [0, 1]
  Vec3 handle_in_world_mm{0.0, 0.0, 0.0};
  bool has_handle = false;  ///< since the last stop
  Vec3 sent_newton{0.0, 0.0, 0.0};
  EnergyAccount account;
  ThermalBudget thermal;
};

struct DeviceForce {
  Vec3 force_in_world_newton{0.0, 0.0, 0.0};
  std::uint32_t limits = 0;  ///< bits of ForceLimit
};

/// The force [N] for the device at this tick.
/// ensures |force| <= force_newton and the heat <= 1; zero where the input is not live or no number; changes by at most the
///         slew otherwise, and what the heat takes
/// errors  none: total, allocates nothing
/// thread  haptic
DeviceForce output_force(ForceOutputState& state, const ForceOutputSettings& settings,
                         const ForceInput& input) noexcept;

}  // namespace hallux::simulator
