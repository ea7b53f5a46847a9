/// The metrics of planned fragments: how far each was shifted, how it lies against the plan and
/// against the other bodies, whether it is held. Inside this corner only.
#pragma once

#include <vector>

#include "assessment/fixation/what_is_left.h"
#include "assessment/measurement.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// ensures every metric of each planned fragment is there; of one that was never parted, or was
/// taken out, none has a value: it was not done
std::vector<Measurement> measure_fragments(const WhatIsLeft& left, const Evidence& evidence);

}  // namespace hallux::assessment
