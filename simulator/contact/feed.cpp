#include "simulator/contact/feed.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

/// Mean threshold over the engaged width [N].
double threshold_newton(const Engagement& engaged) noexcept {
  return (engaged.cortical_mm * cortical_threshold_newton +
          engaged.cancellous_mm * cancellous_threshold_newton) /
         engaged.width_mm();
}

/// Force per rate [N s / mm].
double resistance_newton_s_mm(const Engagement& engaged, double cycles_per_minute) noexcept {
  return (engaged.cortical_mm / cortical_rate_mm2_s_newton +
          engaged.cancellous_mm / cancellous_rate_mm2_s_newton) *
         (law_cycles_per_minute / cycles_per_minute);
}

}  // namespace

double feed_rate_mm_s(const Engagement& engaged, double force_newton, double cycles_per_minute,
                      double bone_quality) noexcept {
  if (!(engaged.width_mm() > 0.0)) return feed_rate_limit_mm_s;
  const double excess_newton = force_newton - bone_quality * threshold_newton(engaged);
  if (!(excess_newton > 0.0)) return 0.0;
  return std::min(
      feed_rate_limit_mm_s,
      excess_newton / (bone_quality * resistance_newton_s_mm(engaged, cycles_per_minute)));
}

}  // namespace hallux::simulator
