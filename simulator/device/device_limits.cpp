#include "simulator/device/device_limits.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

constexpr double usual_push_newton = 20.0;
/// The rest is for guidance and vibration.
constexpr double share_of_force = 0.6;
constexpr double share_of_stiffness = 0.5;

}  // namespace

double usual_force_scale(double force_newton) noexcept {
  return std::min(1.0, share_of_force * force_newton / usual_push_newton);
}

double force_scale_on(const DeviceLimits& limits,
                      double simulated_stiffness_newton_per_mm) noexcept {
  const double wanted = limits.force_scale.value_or(usual_force_scale(limits.force_newton));
  return std::min(wanted, share_of_stiffness * limits.stiffness_newton_per_mm /
                              simulated_stiffness_newton_per_mm);
}

std::optional<DeviceLimits> limits_at_share(const std::optional<DeviceLimits>& limits,
                                            double force_share) noexcept {
  if (!limits || force_share <= 0.0) return std::nullopt;
  DeviceLimits allowed = *limits;
  allowed.force_newton *= force_share;
  allowed.continuous_force_newton *= force_share;
  return allowed;
}

}  // namespace hallux::simulator
