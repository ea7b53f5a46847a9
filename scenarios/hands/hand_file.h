/// A motion of a hand that was written down: it feels nothing.
#pragma once

#include <string_view>

#include "simulator/device/scripted.h"

namespace hallux::scenarios {

/// A motion from a JSON text: {"keys": [{"time_s", "tip_mm", "direction", "normal", "saw"}...]}, in
/// the world frame; and what is said in it, {"commands": [{"time_s", "do", ...}...]}. Without
/// commands the first piece that came free is taken out at the end.
/// errors  ScenarioError with `name`, the path and the mend
simulator::HandMotion parse_hand_motion(std::string_view json, std::string_view name);

}  // namespace hallux::scenarios
