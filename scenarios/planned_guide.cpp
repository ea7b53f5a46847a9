#include "scenarios/planned_guide.h"

#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/check.h"

namespace hallux::scenarios {

simulator::GuidePlan planned_guide(const Scenario& scenario, const Plan& plan,
                                   const simulator::Bones& bones, simulator::Guidance guidance) {
  simulator::GuidePlan guide{guidance, {}};
  if (guidance == simulator::Guidance::None) return guide;
  CHECK(scenario.steps.size() <= guide.of_step.size());
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    const PlannedCut* const cut = cut_at_step(scenario, plan, step);
    // A face is finished bone: the middle of the blade lies half a kerf further into the waste.
    if (cut == nullptr) continue;
    const double offset_mm = cut->face.offset_mm + 0.5 * blade_of(scenario, *cut).kerf_mm;
    const RigidTransform first_from_bone = first_from(bones, cut->bone);
    const Vec3 normal = transform_direction(first_from_bone, cut->face.normal);
    guide.of_step[step] = {normal, offset_mm + glm::dot(normal, first_from_bone.translation_mm)};
  }
  return guide;
}

const PlannedCut* cut_at_step(const Scenario& scenario, const Plan& plan,
                              std::size_t step) noexcept {
  for (; step < scenario.steps.size(); ++step) {
    const OperationStep& each = scenario.steps[step];
    if (is_sawn(each)) return find_cut(plan, each.cut);
    if (each.kind != StepKind::Verify) return nullptr;
  }
  return nullptr;
}

}  // namespace hallux::scenarios
