#include "assessment/fixation/what_is_left.h"

namespace hallux::assessment {

WhatIsLeft what_is_left(const Evidence& evidence) {
  WhatIsLeft left;
  const scenarios::PlannedFixation& planned = evidence.plan.fixation;
  if (planned.fragments.empty() && planned.implants.empty()) return left;
  left.bodies = bodies_of(evidence.rebuilt, evidence.plan, evidence.bone.name);
  left.placements = placements_of(left.bodies, evidence.rebuilt, evidence.plan);
  left.fixation =
      fixation_of(evidence.recording, evidence.rebuilt, left.bodies, evidence.bone, evidence.plan);
  left.is_held = held_by(left.fixation, left.bodies);
  return left;
}

}  // namespace hallux::assessment
