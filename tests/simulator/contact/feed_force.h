/// The feed law turned round: the force that a rate needs.
#pragma once

#include "simulator/contact/feed.h"

namespace hallux::tests {

/// The inverse of feed_rate_mm_s below its ceiling; 0 where no bone is engaged [N].
inline double feed_force_newton(const simulator::Engagement& engaged, double rate_mm_s,
                                double cycles_per_minute, double bone_quality = 1.0) {
  using namespace simulator;
  const double width_mm = engaged.cortical_mm + engaged.cancellous_mm;
  if (!(width_mm > 0.0)) return 0.0;
  const double threshold_newton = (engaged.cortical_mm * cortical_threshold_newton +
                                   engaged.cancellous_mm * cancellous_threshold_newton) /
                                  width_mm;
  const double resistance_newton_s_mm = (engaged.cortical_mm / cortical_rate_mm2_s_newton +
                                         engaged.cancellous_mm / cancellous_rate_mm2_s_newton) *
                                        (law_cycles_per_minute / cycles_per_minute);
  return bone_quality * (threshold_newton + rate_mm_s * resistance_newton_s_mm);
}

}  // namespace hallux::tests
