/// The bone beside a scenario's, for pictures: nothing is cut of it and nothing touches it.
#pragma once

#include "scenarios/scenario.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

/// Coarser than what is cut.
inline constexpr double neighbour_edge_mm = 0.9;

/// The first proximal phalanx of a first metatarsal, and the other way round, where the foot has
/// it.
simulator::Bone neighbour_of(const Scenario& scenario, double edge_mm = neighbour_edge_mm);

}  // namespace hallux::scenarios
