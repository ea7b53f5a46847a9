/// The bodies and implants of an attempt as its metrics need them. Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "assessment/rebuild/bodies.h"
#include "assessment/rebuild/evidence.h"
#include "assessment/rebuild/implants.h"

namespace hallux::assessment {

/// Empty where the operation plans neither fragments nor implants.
struct WhatIsLeft {
  std::vector<Body> bodies;
  /// Of each body.
  std::vector<BodyPlacement> placements;
  std::vector<bool> is_held;
  Fixation fixation;
};

WhatIsLeft what_is_left(const Evidence& evidence);

}  // namespace hallux::assessment
