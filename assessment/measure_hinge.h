/// The metrics of a hinge and of the wedge that its two cuts take out, with their moments and
/// places. Inside this corner only.
#pragma once

#include <span>
#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// All metrics of the wedge and of the bridge. The bridge is the least that any kerf of the two
/// cuts left, and the over-cut the most, because bone that was cut stays cut.
/// needs   measured holds the measurements of both cuts (see measure_cut)
/// ensures every metric is there; the wedge, the bridge and the flatness are measured where both
///         cuts have faces, the over-cut and the loss where one has; an attempt that left a cut
///         undone has a done_fraction of 0
std::vector<Measurement> measure_hinge(const scenarios::PlannedHinge& hinge,
                                       const Evidence& evidence,
                                       std::span<const Measurement> measured);

/// What a kerf of the hinge's cuts left of the bridge, or how far it went beyond, as one number.
struct KerfBridge {
  std::int32_t kerf = -1;
  /// Below 0: beyond the far surface.
  double left_mm = 0.0;
};

/// Of all kerfs of both cuts that opened bone at the bridge.
std::vector<KerfBridge> bridges_left(const scenarios::PlannedHinge& hinge,
                                     const Evidence& evidence);

}  // namespace hallux::assessment
