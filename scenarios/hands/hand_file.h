/// A motion of a hand that was written down: it feels nothing.
#pragma once

#include <string_view>
#include <vector>

#include "scenarios/tray/laid_out_tools.h"
#include "simulator/device/scripted.h"

namespace hallux::scenarios {

/// A motion from a JSON text: {"keys": [{"time_s", "tip_mm", "direction", "normal", "saw", "tool"}
/// ...]}, in the world frame; the "tool" that is in the hand before the first key says one; what
/// the forceps hold, {"grips": [{"from_s", "to_s", "piece", "impact_s"}...]}; and what else is said
/// in it, {"commands": [{"time_s", "do", ...}...]}. Without commands the first piece that came free
/// is taken out at the end.
/// tools   that it may name
/// errors  ScenarioError with `name`, the path and the mend
simulator::HandMotion parse_hand_motion(std::string_view json, std::string_view name,
                                        const std::vector<LaidOutTool>& tools);

}  // namespace hallux::scenarios
