/// Directions in the words of the bone.
#pragma once

#include <string>

#include "simulator/base/vector.h"

namespace hallux::scenarios {

/// "dorsal", "plantar-distal": the bone axes nearest to a direction in the bone frame (x distal, y
/// dorsal, z lateral). A second axis is named where its part is at least half of the first's. Empty
/// for a direction of length 0.
std::string direction_text(const Vec3& direction_in_bone);

}  // namespace hallux::scenarios
