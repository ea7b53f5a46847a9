/// How near the blade came to the joints. Inside this corner only.
#pragma once

#include "assessment/measurement.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// joint_margin_mm. Undefined where the scenario names no joint surface.
Measurement joint_margin_measurement(const Evidence& evidence);

}  // namespace hallux::assessment
