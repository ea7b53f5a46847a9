/// How long a stroke takes under a steady push: the feed law walked through the tissues on its way.
#pragma once

#include <span>
#include <vector>

#include "scenarios/hands/stroke_plan.h"
#include "simulator/contact/tissue.h"
#include "simulator/cutting/kerf.h"

namespace hallux::scenarios {

struct Push {
  double steady_newton = 15.0;
  double exit_newton = 8.0;  ///< in the last millimetres before the far surface
  double exit_mm = 2.5;
};

/// Where the teeth are expected, and the force behind them.
struct FeedMoment {
  double time_s = 0.0;
  double feed_mm = 0.0;
  double push_newton = 0.0;
};

/// From the stroke's first bone to its last, every tenth of a millimetre. What earlier strokes opened is not sawn again, and a
/// hand does not lean on a blade before it meets bone: it would run ahead through the open slot.
/// needs   both pushes are above the cortex's threshold force
std::vector<FeedMoment> predict_feed(const Stroke& stroke, std::span<const Stroke> earlier,
                                     const simulator::KerfPlane& plane,
                                     const simulator::TissueMap& tissue, double blade_width_mm,
                                     double cycles_per_minute, const Push& push);

}  // namespace hallux::scenarios
