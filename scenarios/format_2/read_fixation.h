/// Fragments, shifts and implants of a scenario's JSON. Inside this corner only.
#pragma once

#include "scenarios/fixation/fixation.h"
#include "scenarios/json_node.h"

namespace hallux::scenarios {

/// errors  ScenarioError, all of them: shape and range of each value
Fragment read_fragment(const JsonNode& node);
FragmentShift read_shift(const JsonNode& node);
Implant read_wire(const JsonNode& node);
Implant read_screw(const JsonNode& node);
/// Two rising numbers, each from low to high.
Range read_range(const JsonNode& node, double low, double high);

}  // namespace hallux::scenarios
