#include "scenarios/hands/planned_strokes.h"

#include "scenarios/hands/hand_aim.h"
#include "scenarios/hands/stroke_plan.h"

namespace hallux::scenarios {

namespace {

HandSkill faultless() {
  HandSkill skill;
  skill.angle_mean_deg = skill.angle_deviation_deg = 0.0;
  skill.location_mean_mm = skill.location_deviation_mm = 0.0;
  skill.stop_mean_mm = skill.stop_deviation_mm = skill.meet_deviation_mm = 0.0;
  return skill;
}

}  // namespace

std::vector<PlannedStroke> planned_strokes(const Scenario& scenario, const simulator::Bone& bone,
                                           const Plan& plan) {
  const HandSkill skill = faultless();
  const std::vector<AimedCut> aims = aim(scenario, plan, KnownBone(bone), skill, 0);
  std::vector<PlannedStroke> planned;
  for (const OperationStep& step : scenario.steps) {
    if (step.kind != StepKind::Cut) continue;
    const std::size_t cut = index_of_cut(plan, step.cut);
    const AimedCut& aimed = aims[cut];
    std::vector<Stroke> strokes = plan_strokes(
        aimed.region,
        {.blade_width_mm = scenario.saw.blade.width_mm, .margin_mm = skill.edge_margin_mm});
    if (aimed.stop_mm) strokes = stopped(strokes, *aimed.stop_mm);
    for (const Stroke& stroke : strokes) {
      planned.push_back({cut, aimed.plane, stroke.along_mm, stroke.first_mm, stroke.end_mm});
    }
  }
  return planned;
}

}  // namespace hallux::scenarios
