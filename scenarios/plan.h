/// A scenario's plan on one patient: planes and points in that bone's frame.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

/// A finished bone face: points p with normal . p = offset; the bone on the side of the normal is waste.
struct ReferenceFace {
  Vec3 normal{0.0, 0.0, -1.0};
  double offset_mm = 0.0;
};

struct PlannedCut {
  std::string name;
  ReferenceFace face;
  Vec3 axis{1.0, 0.0, 0.0};  ///< unit direction in the face, distal
  Vec3 depth_point_in_bone_mm{0.0, 0.0, 0.0};
  Vec3 exit_point_in_bone_mm{0.0, 0.0, 0.0};
  double depth_mm =
      0.0;  ///< planned signed distance of the face from the depth point, towards the waste
};

struct Plan {
  std::vector<PlannedCut> cuts;
};

/// The face of the plane on this bone.
/// errors  ScenarioError naming the landmark that this bone lacks, or the cut whose plane misses the bone
Plan plan_on(const Scenario& scenario, const simulator::Bone& bone);

/// The patient that the scenario asks for; `progress` is told the fraction done and may return false to cancel.
/// errors  ScenarioError (see make_first_metatarsal)
simulator::Bone make_patient(const Scenario& scenario,
                             const std::function<bool(double)>& progress = {});

}  // namespace hallux::scenarios
