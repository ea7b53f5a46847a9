/// What an attempt leaves, as its metrics and its exports need it: the bodies and how they lie, the
/// implants and what they hold.
#pragma once

#include <vector>

#include "assessment/rebuild/bodies.h"
#include "assessment/rebuild/implants.h"

namespace hallux::assessment {

struct WhatIsLeft {
  std::vector<Body> bodies;
  /// Of each body.
  std::vector<BodyPlacement> placements;
  std::vector<bool> is_held;
  Fixation fixation;
};

/// rebuilt  from that recording of those bones
/// plan     on them
WhatIsLeft what_is_left(const simulator::Recording& recording, const RebuiltBone& rebuilt,
                        const simulator::Bones& bones, const scenarios::Plan& plan);

}  // namespace hallux::assessment
