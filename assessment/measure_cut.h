/// The metrics of one planned cut, with their moments and places. Inside this corner only.
#pragma once

#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/cut_face.h"
#include "scenarios/plan.h"

namespace hallux::assessment {

/// angle_deg, location_mm, depth_mm, step_mm, flatness_mm, past_landmark_mm and notch_mm, in this
/// order; of a cut across the bone only angle_deg, location_mm and flatness_mm. The first face is
/// measured; past_landmark_mm and notch_mm are the worst of all faces, because bone that was cut
/// stays cut.
/// ensures every metric is there; without a face that has samples none of them is measured
std::vector<Measurement> measure_cut(const scenarios::PlannedCut& planned,
                                     const std::vector<CutFace>& faces, const RebuiltBone& rebuilt,
                                     const simulator::Bone& bone,
                                     const simulator::Recording& recording);

}  // namespace hallux::assessment
