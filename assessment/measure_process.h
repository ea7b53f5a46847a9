/// How the work was done: the metrics of the whole attempt and of the danger zones.
/// Inside this corner only.
#pragma once

#include <vector>

#include "assessment/measurement.h"
#include "assessment/process/followed_effects.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// Everything that a rubric may ask of an attempt besides what its kerfs tell; the
/// metrics of danger zones for each zone and, with an empty one, for all of them together.
/// effects  followed over the whole recording
/// surface  of all bones as they were, in the frame of the first
/// ensures  every metric is there. What no bone was sawn for is not made; each earns no more than
///          the share of the planned cuts that was sawn, so that sawing nothing is no safe sawing
/// errors   ScenarioError (see measure_path_ratio); those of whoever keeps the tape
std::vector<Measurement> measure_process(const Evidence& evidence, const FollowedEffects& effects,
                                         const simulator::Bvh& surface);

}  // namespace hallux::assessment
