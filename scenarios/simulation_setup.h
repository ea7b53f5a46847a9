/// A scenario's operation on one patient as the simulator runs it.
#pragma once

#include "scenarios/plan.h"
#include "simulator/step/simulation.h"

namespace hallux::scenarios {

/// The same for an attempt, for its replay, and for whoever computes heat and bend again.
/// plan      of this scenario on these bones
/// guidance  how firmly the planned planes lead the hand
/// ensures borrows the bones; danger zones and the guide are said in the frame of the first
simulator::SimulationSetup simulation_setup(const Scenario& scenario, simulator::Bones bones,
                                            const Plan& plan, simulator::Guidance guidance);

}  // namespace hallux::scenarios
