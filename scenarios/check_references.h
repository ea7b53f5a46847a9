/// What the parts of a scenario must say of each other. Inside this corner only.
#pragma once

#include <string_view>

#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// errors  ScenarioError naming `file` and the path: a name given twice, a cut, hinge or group that
///         does not exist, steps out of order, a hinge between faces that do not meet at it,
///         weights that do not add up
void check_references(const Scenario& scenario, std::string_view file);

}  // namespace hallux::scenarios
