#include "scenarios/simulation_setup.h"

#include "scenarios/planned_guide.h"
#include "scenarios/tray/laid_out_tools.h"

namespace hallux::scenarios {

simulator::SimulationSetup simulation_setup(const Scenario& scenario, const simulator::Bone& bone,
                                            const Plan& plan, simulator::Guidance guidance) {
  simulator::SimulationSetup setup{bone, tray_of(scenario)};
  setup.contact.bone_quality = scenario.patient.bone_quality;
  setup.contact.guide = planned_guide(scenario, plan, guidance);
  setup.bridges = planned_bridges(plan);
  for (const PlannedZone& zone : plan.danger_zones) setup.danger_zones.push_back(zone.capsule);
  return setup;
}

}  // namespace hallux::scenarios
