/// A plan with all of its parts said in the frame of the first bone, as the bones lie before
/// anything is moved: for who looks at a patient as one.
#pragma once

#include "scenarios/plan.h"

namespace hallux::scenarios {

/// Each part still tells its bone. Of one bone it is the same plan.
Plan plan_in_first(Plan plan, const simulator::Bones& bones);

}  // namespace hallux::scenarios
