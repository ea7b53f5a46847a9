/// How thick the bone is that a step takes out. Inside this corner only.
#pragma once

#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/bone_surfaces.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// thickness_mm and thickness_max_mm for each step that removes: the mean and the greatest of what
/// lies over the points of the face that counts, along its normal to the bone's surface; of a
/// wedge, over the first face to the second one. The saw's own kerf is in it.
/// surfaces  of the bones as they were
/// ensures   without faces both are there and not measured
std::vector<Measurement> measure_pieces(const Evidence& evidence, const BoneSurfaces& surfaces);

}  // namespace hallux::assessment
