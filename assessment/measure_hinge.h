/// The metrics of a hinge and of the wedge that its two cuts take out, with their moments and
/// places. Inside this corner only.
#pragma once

#include <span>
#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/cut_face.h"
#include "scenarios/plan.h"

namespace hallux::assessment {

/// What an attempt left, as the metrics of a hinge need it; borrowed for the call.
struct HingeEvidence {
  const scenarios::Plan& plan;
  const RebuiltBone& rebuilt;
  /// Per planned cut (see faces_of_cut).
  const std::vector<std::vector<CutFace>>& faces;
  const simulator::Bone& bone;
  const simulator::Recording& recording;
};

/// wedge_error_deg, wedge_sagittal_deg, hinge_mm, flatness_mm, over_cut_mm and hinge_lost, in this
/// order. The bridge is the least that any kerf of the two cuts left, and the over-cut the most,
/// because bone that was cut stays cut.
/// needs   measured holds the measurements of both cuts (see measure_cut)
/// ensures every metric is there; the wedge, the bridge and the flatness are measured where both
///         cuts have faces, the over-cut and the loss where one has; an attempt that left a cut
///         undone has a done_fraction of 0
std::vector<Measurement> measure_hinge(const scenarios::PlannedHinge& hinge,
                                       const HingeEvidence& evidence,
                                       std::span<const Measurement> measured);

}  // namespace hallux::assessment
