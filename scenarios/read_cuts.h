/// The cuts, hinges and steps of a scenario's JSON in format 1. Inside this corner only.
#pragma once

#include "scenarios/json_node.h"
#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// errors  ScenarioError, all of them: shape and range of each value; what the parts say of each
///         other is check_references
ReferenceCut read_cut(const JsonNode& node);
ReferenceHinge read_hinge(const JsonNode& node);
OperationStep read_step(const JsonNode& node);
/// Of a hinge how thick it is to stay.
void read_bridge(const JsonNode& node, ReferenceHinge& hinge);

}  // namespace hallux::scenarios
