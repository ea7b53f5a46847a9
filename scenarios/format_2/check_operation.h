/// What no single value of a scenario of format 2 can say of itself. Inside this corner only.
#pragma once

#include <string_view>

#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// Names that others use, the order in which things are placed, and what the steps do with them.
/// Whether a landmark is there is known on a bone only (plan_on).
/// file    stands in the messages
/// errors  ScenarioError with path and mend, of the first that is found
void check_operation(const Scenario& scenario, std::string_view file);

}  // namespace hallux::scenarios
