/// The joint surfaces of a scenario on one patient. Inside this corner only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/geometry/ground.h"

namespace hallux::scenarios {

struct PlannedJointSurface {
  std::string name, title;
  Vec3 centre_in_bone_mm{0.0, 0.0, 0.0};
  /// Of the bone's outer surface, ascending.
  std::vector<std::uint32_t> triangles;
  /// Of the patient's bones.
  std::size_t bone = 0;
};

/// In the order of the scenario. A triangle belongs to a surface where its centroid lies within the
/// radius of the landmark and its normal within the angle of the direction.
/// errors  ScenarioError naming the landmark that this bone lacks, or the surface on which no
///         triangle lies
std::vector<PlannedJointSurface> plan_joint_surfaces(const Scenario& scenario,
                                                     const Ground& ground);

}  // namespace hallux::scenarios
