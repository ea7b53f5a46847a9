#include "scenarios/hands/planned_strokes.h"

#include "scenarios/hands/cut_strokes.h"
#include "scenarios/hands/hand_aim.h"
#include "scenarios/tray/laid_out_tools.h"

namespace hallux::scenarios {

std::vector<PlannedStroke> planned_strokes(const Scenario& scenario, simulator::Bones bones,
                                           const Plan& plan) {
  const HandSkill skill = hand_skill("perfect");
  const std::vector<AimedCut> aims = aim(scenario, plan, KnownBones(bones), skill, 0);
  std::vector<PlannedStroke> planned;
  for (const OperationStep& step : scenario.steps) {
    if (!is_sawn(step)) continue;
    const std::size_t cut = index_of_cut(plan, step.cut);
    const AimedCut& aimed = aims[cut];
    for (const Stroke& stroke : cut_strokes(aimed, blade_of(scenario, plan.cuts[cut]), skill)) {
      planned.push_back({cut, aimed.plane, stroke.along_mm, stroke.first_mm, stroke.end_mm});
    }
  }
  return planned;
}

}  // namespace hallux::scenarios
