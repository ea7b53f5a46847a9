/// What a haptic device bears and gives, and how many of its newtons stand for a simulated one.
/// Inside this corner only.
///
/// The simulation computes, records and scores its own newtons: a saw is pushed with 8 to 20 N, an
/// arm gives 3 to 12. What the hand feels is made of them afterwards and never comes back into the
/// record.
#pragma once

#include <cstdint>
#include <optional>

namespace hallux::simulator {

inline constexpr std::int32_t transport_ticks_at_most = 3;

struct DeviceLimits {
  /// The greatest, for a moment, in any direction.
  double force_newton = 0.0;
  /// That its motors bear for ever.
  double continuous_force_newton = 0.0;
  /// In which its motors warm to 63 %.
  double thermal_time_s = 10.0;
  /// Of the stiffest wall that it renders.
  double stiffness_newton_per_mm = 0.0;
  /// The greatest that it renders.
  double damping_newton_s_per_mm = 0.0;
  double slew_newton_per_s = 500.0;
  /// From sending a force until it acts.
  std::int32_t transport_ticks = 0;
  /// Its motors follow 90 to 150 Hz.
  bool renders_vibration = false;
  /// Device newtons per simulated newton, where it says one.
  std::optional<double> force_scale = std::nullopt;
};

/// Of the greatest force, for the tremble of a running saw; the contact takes six tenths, guidance
/// the rest.
/// source  docs/haptics.md, What an arm is given
inline constexpr double vibration_share_of_force = 0.15;

/// A push of 20 N, the upper end of what is usual, takes six tenths of what the device gives:
/// min(1, 0.6 F / 20 N).
/// source  docs/haptics.md, What an arm is given
double usual_force_scale(double force_newton) noexcept;

/// Device newtons per simulated newton on that device, for a contact that is at most so stiff: the
/// device's own word or the usual scale, made smaller until the contact takes at most half of the
/// stiffness that the device renders.
/// needs   stiffness above 0
double force_scale_on(const DeviceLimits& limits,
                      double simulated_stiffness_newton_per_mm) noexcept;

/// What is felt of it where only a share of its force [0, 1] is allowed; nothing: nobody is pushed.
std::optional<DeviceLimits> limits_at_share(const std::optional<DeviceLimits>& limits,
                                            double force_share) noexcept;

}  // namespace hallux::simulator
