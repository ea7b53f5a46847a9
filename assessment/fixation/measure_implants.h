/// The metrics of planned wires and screws, and of groups of alternatives that set some.
/// Inside this corner only.
#pragma once

#include <vector>

#include "assessment/fixation/what_is_left.h"
#include "assessment/measurement.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// ensures every metric of each planned implant is there, and of each group of alternative steps:
///         the worst among the implants of the one that was carried out. Of an implant that was not
///         set, or should have stayed and was taken out, none has a value: it was not done; but
///         where another alternative was carried out nothing is lost
std::vector<Measurement> measure_implants(const WhatIsLeft& left, const Evidence& evidence);

}  // namespace hallux::assessment
