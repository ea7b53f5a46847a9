/// The planes of a plan as the simulator leads a hand to them.
#pragma once

#include "scenarios/plan.h"
#include "simulator/contact/guide.h"

namespace hallux::scenarios {

/// For each step the middle of the blade in the cut that is made in it, or next after it while
/// there is only to be looked; nothing for the others.
/// needs   a plan of this scenario on these bones
/// ensures said in the frame of the first bone
simulator::GuidePlan planned_guide(const Scenario& scenario, const Plan& plan,
                                   const simulator::Bones& bones, simulator::Guidance guidance);

/// The cut of that step, or the next after it while there is only to be looked; null where the step
/// has another purpose. It lives as long as the plan.
const PlannedCut* cut_at_step(const Scenario& scenario, const Plan& plan,
                              std::size_t step) noexcept;

}  // namespace hallux::scenarios
