/// The danger zones of a scenario on one patient. Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "simulator/contact/danger_zone.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

struct PlannedZone {
  std::string name;
  simulator::DangerCapsule capsule;
};

/// In the order of the scenario.
/// errors  ScenarioError naming the landmark that this bone lacks, or the zone that lies so far
///         from the bone that no blade comes there
std::vector<PlannedZone> plan_zones(const Scenario& scenario, const simulator::Bone& bone);

}  // namespace hallux::scenarios
