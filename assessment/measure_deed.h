/// The deeds that an operation asks for besides its cuts: a piece that is out, a wedge that is
/// closed. Inside this corner only.
#pragma once

#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/evidence.h"
#include "simulator/base/progress.h"

namespace hallux::assessment {

/// piece_out for each step that removes, wedge_closed for each that closes, in the order of the
/// steps: 1 where it was done, 0 where not, always measured. A piece is out where most of the bone
/// beyond the measured face (of a wedge: between its two faces) was free and taken out.
/// errors  Cancelled
/// thread  any
std::vector<Measurement> measure_deeds(const Evidence& evidence, const Progress& progress = {});

}  // namespace hallux::assessment
