/// The bone beside a scenario's, for pictures: nothing is cut of it and nothing touches it.
#pragma once

#include <optional>

#include "scenarios/patient.h"

namespace hallux::scenarios {

/// Coarser than what is cut.
inline constexpr double neighbour_edge_mm = 0.9;

/// Beside the scenario's first bone, where the foot has it; nothing where it is operated on, too.
/// bones   the rows that may be asked for; each names a neighbour among them
/// errors  ScenarioError where no row has the bone's name
std::optional<simulator::Bone> neighbour_of(const Scenario& scenario,
                                            double edge_mm = neighbour_edge_mm,
                                            std::span<const FootBone> bones = foot_bones());

}  // namespace hallux::scenarios
