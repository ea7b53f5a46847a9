/// The hinge of a plan as the simulator closes it.
#pragma once

#include <optional>

#include "scenarios/plan.h"
#include "simulator/bone/planned_bridge.h"

namespace hallux::scenarios {

/// The plan's first hinge, its distal half turning; nothing where the plan has none.
std::optional<simulator::PlannedBridge> planned_bridge(const Plan& plan);

}  // namespace hallux::scenarios
