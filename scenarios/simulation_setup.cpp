#include "scenarios/simulation_setup.h"

#include "scenarios/planned_guide.h"
#include "scenarios/tray/laid_out_tools.h"

namespace hallux::scenarios {

simulator::SimulationSetup simulation_setup(const Scenario& scenario, simulator::Bones bones,
                                            const Plan& plan, simulator::Guidance guidance) {
  simulator::SimulationSetup setup{bones.first(), tray_of(scenario)};
  for (std::size_t bone = 1; bone < bones.size(); ++bone)
    setup.further_bones.push_back(&bones[bone]);
  setup.contact.bone_quality = scenario.patient.bone_quality;
  setup.contact.guide = planned_guide(scenario, plan, bones, guidance);
  setup.bridges = planned_bridges(plan);
  setup.danger_zones = capsules_of(plan.danger_zones, bones);
  return setup;
}

}  // namespace hallux::scenarios
