/// What closing a wedge made of the bone. Inside this corner only.
#pragma once

#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// correction_deg, shortening_mm, gap_mm and contact_share for each step that closes, from the pose
/// in which the half that turned came to lie.
/// ensures  where nothing was closed all are there, as not done
std::vector<Measurement> measure_closings(const Evidence& evidence);

}  // namespace hallux::assessment
