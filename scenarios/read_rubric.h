/// The rubric part of a scenario's JSON. Inside this corner only.
#pragma once

#include "scenarios/json_node.h"
#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// errors  ScenarioError: shape and range of each value; what the parts say of each other is
///         check_references
Rubric read_rubric(const JsonNode& node);

}  // namespace hallux::scenarios
