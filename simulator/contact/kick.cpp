#include "simulator/contact/kick.h"

#include <algorithm>
#include <cstddef>

namespace hallux::simulator {

namespace {

/// The share of the impulse that is over at a share of the duration: the integral of the parabola 6
/// s (1 - s).
double share_over(double age_s) noexcept {
  const double share = std::clamp(age_s / kick_duration_s, 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

}  // namespace

double side_away_from(std::span<const Tissue> teeth) noexcept {
  std::ptrdiff_t lean = 0;
  for (std::size_t tooth = 0; tooth < teeth.size(); ++tooth) {
    const auto mirrored = static_cast<std::ptrdiff_t>(teeth.size() - 1 - tooth);
    if (is_bone(teeth[tooth])) lean += static_cast<std::ptrdiff_t>(tooth) - mirrored;
  }
  return lean > 0 ? -1.0 : 1.0;
}

bool is_corner(std::span<const Tissue> teeth, double tooth_mm) noexcept {
  const std::ptrdiff_t in_bone = std::count_if(teeth.begin(), teeth.end(), is_bone);
  if (in_bone == 0 || static_cast<double>(in_bone) * tooth_mm >= kick_corner_mm) return false;
  const bool is_at_first = std::all_of(teeth.begin(), teeth.begin() + in_bone, is_bone);
  const bool is_at_last = std::all_of(teeth.end() - in_bone, teeth.end(), is_bone);
  return is_at_first || is_at_last;
}

bool begin_kick(KickState& kick, double side) noexcept {
  if (kick.age_s < kick_rest_s) return false;
  kick.side = side;
  kick.age_s = 0.0;
  return true;
}

double kick_newton(KickState& kick, double duration_s) noexcept {
  const double before_s = kick.age_s;
  kick.age_s = std::min(kick_rest_s, before_s + duration_s);
  const double share = share_over(before_s + duration_s) - share_over(before_s);
  return kick.side * share * kick_impulse_newton_s / duration_s;
}

}  // namespace hallux::simulator
