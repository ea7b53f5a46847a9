#include "scenarios/simulation_setup.h"

#include "scenarios/planned_bridge.h"
#include "scenarios/planned_guide.h"

namespace hallux::scenarios {

simulator::SimulationSetup simulation_setup(const Scenario& scenario, const simulator::Bone& bone,
                                            const Plan& plan, simulator::Guidance guidance) {
  simulator::SimulationSetup setup{bone, scenario.saw};
  setup.contact.bone_quality = scenario.patient.bone_quality;
  setup.contact.guide = planned_guide(scenario, plan, guidance);
  setup.bridge = planned_bridge(plan);
  setup.danger_zones = capsules_of(plan.danger_zones);
  return setup;
}

}  // namespace hallux::scenarios
