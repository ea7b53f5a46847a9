#include "simulator/contact/coupling.h"

#include <algorithm>

namespace hallux::simulator {

double share_within(const Vec3& value, double limit) noexcept {
  const double size = length_of(value);
  return size > limit ? limit / size : 1.0;
}

CouplingPull coupling_pull(const ProxyMotion& stretch, const ContactSettings& settings) noexcept {
  CouplingPull pull;
  const Vec3 force_newton = settings.coupling_newton_per_mm * stretch.translation_mm;
  const double force_share = share_within(force_newton, settings.force_limit_newton);
  pull.force_newton = force_share * force_newton;
  pull.is_force_limited = force_share < 1.0;
  const Vec3 torque_newton_mm = settings.torsion_newton_mm_per_rad * stretch.rotation_rad;
  pull.torque_newton_mm =
      share_within(torque_newton_mm, settings.torque_limit_newton_mm) * torque_newton_mm;
  return pull;
}

double travel_limit_mm(double hand_way_mm, double duration_s, bool is_gentle,
                       const ContactSettings& settings) noexcept {
  const double follows_mm = hand_way_mm + settings.release_speed_mm_s * duration_s;
  return is_gentle ? std::min(tick_travel_limit_mm, follows_mm) : tick_travel_limit_mm;
}

}  // namespace hallux::simulator
