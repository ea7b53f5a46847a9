/// The metrics of one planned cut, with their moments and places. Inside this corner only.
#pragma once

#include <cstddef>
#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// All metrics of one planned cut that lie in its kind (see scenarios/metric_names.h). The first
/// face is measured; past_landmark_mm, notch_mm and the break-throughs are the worst of all faces,
/// because bone that was cut stays cut.
/// ensures every metric is there; without a face that has samples none of them is measured
std::vector<Measurement> measure_cut(std::size_t cut, const Evidence& evidence);

}  // namespace hallux::assessment
