/// What format 2 says in words of its own: bones, blades, geometry, cuts, hinges, fixation, steps.
/// Inside this corner only.
#pragma once

#include <span>

#include "scenarios/json_node.h"
#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// errors  ScenarioError: shape and range of each value; what the parts say of each other is
///         check_operation
void read_operation(const JsonNode& root, std::span<const FootBone> bones, Scenario& scenario);

}  // namespace hallux::scenarios
