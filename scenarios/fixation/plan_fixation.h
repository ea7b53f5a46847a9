/// Lays fragments, shifts and implants of a scenario on one patient. Inside this corner only.
#pragma once

#include <span>
#include <vector>

#include "scenarios/fixation/planned_fixation.h"
#include "scenarios/geometry/ground.h"
#include "scenarios/planned_joints.h"

namespace hallux::scenarios {

struct PlannedCut;

/// cuts   the planned faces that part the fragments
/// errors ScenarioError: a fragment that no cut parts from its bone, two in one piece, an implant
///        whose axis misses a body that it must engage, or comes too near to a joint surface
PlannedFixation plan_fixation(const Scenario& scenario, const Ground& ground,
                              std::span<const PlannedCut> cuts,
                              std::span<const PlannedJointSurface> joint_surfaces);

}  // namespace hallux::scenarios
