#include "scenarios/neighbour.h"

#include "simulator/base/check.h"

namespace hallux::scenarios {

simulator::Bone neighbour_of(const Scenario& scenario, double edge_mm,
                             std::span<const FootBone> bones) {
  const FootBone& own = foot_bone_of(scenario, scenario.patient, bones);
  const FootBone* const beside = find_foot_bone(own.neighbour, bones);
  CHECK(beside != nullptr);
  return make_foot_bone(*beside, {.edge_mm = edge_mm});
}

}  // namespace hallux::scenarios
