#include "scenarios/planned_bridge.h"

namespace hallux::scenarios {

std::optional<simulator::PlannedBridge> planned_bridge(const Plan& plan) {
  if (plan.hinges.empty()) return std::nullopt;
  const PlannedHinge& hinge = plan.hinges.front();
  simulator::PlannedBridge bridge;
  bridge.line = {hinge.point_in_bone_mm, hinge.axis, hinge.outward, hinge.thickness_mm};
  bridge.toward_moved = Vec3(1.0, 0.0, 0.0);
  bridge.breaks_below_mm = hinge.breaks_below_mm;
  bridge.bends_up_to_mm = hinge.bends_up_to_mm;
  return bridge;
}

}  // namespace hallux::scenarios
