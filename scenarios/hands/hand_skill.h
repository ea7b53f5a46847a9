/// How well a scripted hand does what it means to do: the sizes of its errors.
#pragma once

#include <string_view>

#include "scenarios/hands/stroke_timing.h"

namespace hallux::scenarios {

/// Means and deviations of normal numbers; the defaults are the expert's. source  docs/hands.md
struct HandSkill {
  double angle_mean_deg = 2.5, angle_deviation_deg = 1.5;  ///< between the aimed face and the plan
  double location_mean_mm = 0.8,
         location_deviation_mm = 0.5;  ///< largest distance between them over the section
  double wander_mm = 0.3;              ///< out of the plane while sawing
  double wander_rad = 0.01;
  double stroke_jitter_mm = 0.1;  ///< out of the plane from stroke to stroke
  double stroke_jitter_rad = 0.005;
  double approach_mm_s = 30.0;
  Push push;  ///< the force it means to keep
  /// Where a cut is to stop inside the bone: how far beyond the planned line it stops.
  double stop_mean_mm = -0.4, stop_deviation_mm = 0.3;
  double meet_deviation_mm = 0.2;  ///< how well a second cut comes to the end of the first
  int looks = 0;                   ///< withdrawals within a stroke to see how deep it is
};

/// errors  ScenarioError naming the hands there are
HandSkill hand_skill(std::string_view name);

}  // namespace hallux::scenarios
