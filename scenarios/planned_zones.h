/// The danger zones of a scenario on one patient. Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "scenarios/geometry/ground.h"
#include "simulator/contact/danger_zone.h"

namespace hallux::scenarios {

struct PlannedZone {
  std::string name;
  simulator::DangerCapsule capsule;
  /// Of the patient's bones, in whose frame it is said.
  std::size_t bone = 0;
};

/// In the order of the scenario.
/// errors  ScenarioError naming the landmark that this bone lacks, or the zone that lies so far
///         from the bone that no blade comes there
std::vector<PlannedZone> plan_zones(const Scenario& scenario, const Ground& ground);

/// As the step watches them: in the frame of the first bone.
std::vector<simulator::DangerCapsule> capsules_of(const std::vector<PlannedZone>& zones,
                                                  const simulator::Bones& bones);

}  // namespace hallux::scenarios
