/// The fine roughness of a bone's surface: two octaves of value noise. Inside this corner only.
#pragma once

#include "scenarios/foot/dual.h"

namespace hallux::scenarios {

/// Between -1.2 and 1.2, mean near 0; wavelengths 4.2 and 1.6 mm.
Dual relief_at(const Vec3& point_mm) noexcept;

}  // namespace hallux::scenarios
