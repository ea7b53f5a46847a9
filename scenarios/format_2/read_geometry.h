/// The named points and directions of a scenario's JSON. Inside this corner only.
#pragma once

#include "scenarios/geometry/named_geometry.h"
#include "scenarios/json_node.h"

namespace hallux::scenarios {

/// errors  ScenarioError, both: shape and range of each value, and another choice of keys than one
///         of the kinds has
NamedPoint read_point(const JsonNode& node);
NamedDirection read_named_direction(const JsonNode& node);

}  // namespace hallux::scenarios
