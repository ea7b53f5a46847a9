/// The part of a section that a cut is to open where it stops at a hinge.
#pragma once

#include "scenarios/plan.h"

namespace hallux::scenarios {

/// Bone with outward . p <= limit. `outward` is a unit vector.
struct PlannedWindow {
  Vec3 outward{0.0, 0.0, 1.0};
  double limit_mm = 0.0;
};

/// Up to where the thickest bridge on target would begin, or to where two kerfs of this thickness
/// lie in each other anyway, whichever is further from the cortex.
/// source  docs/metrics.md, "Unfinished cuts"
PlannedWindow window_before(const PlannedHinge& hinge, double kerf_mm) noexcept;

}  // namespace hallux::scenarios
