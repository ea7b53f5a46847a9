#include "assessment/fixation/what_is_left.h"

namespace hallux::assessment {

WhatIsLeft what_is_left(const simulator::Recording& recording, const RebuiltBone& rebuilt,
                        const simulator::Bones& bones, const scenarios::Plan& plan) {
  WhatIsLeft left;
  left.bodies = bodies_of(rebuilt, plan, bones);
  left.placements = placements_of(left.bodies, rebuilt, plan);
  left.fixation = fixation_of(recording, rebuilt, left.bodies, bones, plan);
  left.is_held = held_by(left.fixation, left.bodies);
  return left;
}

}  // namespace hallux::assessment
