#include "scenarios/neighbour.h"

#include <algorithm>

#include "simulator/base/check.h"

namespace hallux::scenarios {

std::optional<simulator::Bone> neighbour_of(const Scenario& scenario, double edge_mm,
                                            std::span<const FootBone> bones) {
  const FootBone& own = foot_bone_of(scenario, scenario.patient, bones);
  const FootBone* const beside = find_foot_bone(own.neighbour, bones);
  CHECK(beside != nullptr);
  if (std::ranges::find(scenario.further_bones, own.neighbour, &PatientRequest::bone) !=
      scenario.further_bones.end())
    return std::nullopt;
  return make_foot_bone(*beside, {.edge_mm = edge_mm});
}

}  // namespace hallux::scenarios
