#include "simulator/device/rate_control.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// Slower turns are none.
constexpr double least_turn_rad = 1e-9;

/// Gentle near the middle: the square of what lies beyond the dead zone.
double response(double share, double dead_share) noexcept {
  const double beyond = std::clamp((std::abs(share) - dead_share) / (1.0 - dead_share), 0.0, 1.0);
  return std::copysign(beyond * beyond, share);
}

}  // namespace

Vec3 rate_response(const Vec3& shares, double dead_share) noexcept {
  return {response(shares.x, dead_share), response(shares.y, dead_share),
          response(shares.z, dead_share)};
}

void RateControl::advance(const Deflection& deflection, const Quat& world_from_view) noexcept {
  const double follow = std::min(1.0, step_s / settings_.smoothing_s);
  const Vec3 wanted_mm_s =
      settings_.speed_mm_s * rate_response(deflection.pushed, settings_.dead_share);
  const Vec3 wanted_rad_s =
      settings_.turn_rad_s * rate_response(deflection.turned, settings_.dead_share);
  velocity_mm_s_ += follow * (wanted_mm_s - velocity_mm_s_);
  turn_rad_s_ += follow * (wanted_rad_s - turn_rad_s_);
  world_from_hand_.translation_mm += world_from_view * (step_s * velocity_mm_s_);
  const Vec3 turn_rad = world_from_view * (step_s * turn_rad_s_);
  const double angle_rad = length_of(turn_rad);
  if (angle_rad < least_turn_rad) return;
  world_from_hand_.rotation =
      normalised(rotation_about(turn_rad / angle_rad, angle_rad) * world_from_hand_.rotation);
}

}  // namespace hallux::simulator
