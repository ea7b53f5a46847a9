/// What the steps of format 2 are about, and what must be done before each.
/// Inside this corner only.
#pragma once

#include <string_view>

#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// errors  ScenarioError: order (check_step_order), a subject that is missing, unknown, or not of
///         that kind of step, a deed before what it needs, a cut, shift or implant that no step is
///         about
void check_ordered_steps(const Scenario& scenario, std::string_view file);

}  // namespace hallux::scenarios
