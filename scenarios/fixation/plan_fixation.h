/// Lays fragments, shifts and implants of a scenario on one patient. Inside this corner only.
#pragma once

#include <vector>

#include "scenarios/fixation/planned_fixation.h"
#include "scenarios/geometry/ground.h"

namespace hallux::scenarios {

struct Plan;

/// plan   with the faces that part the fragments, the hinges that close, and the joint surfaces
/// errors ScenarioError: a fragment that no cut parts from its bone, two in one piece, an implant
///        whose axis misses a body that it must engage, or comes too near to a joint surface
PlannedFixation plan_fixation(const Scenario& scenario, const Ground& ground, const Plan& plan);

}  // namespace hallux::scenarios
