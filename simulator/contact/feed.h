/// The feed law: how fast a running saw advances through mixed tissue under a force.
///
/// Per tissue the rate is K (F - F0) (cycles / 12000) / width. Over a tooth line in several tissues
/// the forces add up: each engaged width carries its own share, so F = F0 + rate * sum(width_i /
/// K_i) * (12000 / cycles). Bone of another quality needs so many times that force, at each rate
/// and to begin.
/// source  docs/haptics.md; calibrated to published micro-saw feeds of 10 to 60 mm/min, not
///         measured by us
#pragma once

#include "simulator/tool/saw.h"

namespace hallux::simulator {

/// How much of the tooth line stands in each tissue [mm].
struct Engagement {
  double cortical_mm = 0.0;
  double cancellous_mm = 0.0;

  double width_mm() const noexcept { return cortical_mm + cancellous_mm; }
};

/// K [mm2 / (s N)] and F0 [N] of the law, and its ceiling.
inline constexpr double cortical_rate_mm2_s_newton = 0.35;
inline constexpr double cortical_threshold_newton = 1.5;
inline constexpr double cancellous_rate_mm2_s_newton = 2.0;
inline constexpr double cancellous_threshold_newton = 0.3;
inline constexpr double feed_rate_limit_mm_s = 5.0;
inline constexpr double law_cycles_per_minute = 12000.0;

/// Advance along the feed direction; the ceiling where no bone is engaged, 0 below the threshold
/// force [mm/s].
/// needs   bone_quality > 0; 1 is bone as the constants have it
double feed_rate_mm_s(const Engagement& engaged, double force_newton, double cycles_per_minute,
                      double bone_quality = 1.0) noexcept;

/// The same for a saw with its drive and the sharpness of its blade.
inline double feed_rate_mm_s(const Engagement& engaged, double force_newton, const Saw& saw,
                             double bone_quality) noexcept {
  return feed_rate_mm_s(engaged, force_newton, sharp_cycles_per_minute(saw), bone_quality);
}

}  // namespace hallux::simulator
