/// One tick of a tool with a point that is in no bore: free in air, or held out of the bone by
/// point and shaft. Inside this corner only.
///
/// Part of bore_motion.h, and called by it alone.
#pragma once

#include "simulator/contact/bore/bore_motion.h"

namespace hallux::simulator {

/// Moves the tool by at most `travel_limit_mm`. In OnBone a running point is fed into the bone.
void move_outside_bore(BoreToolState& tool, const BoreInput& input, const DrilledWound& bone,
                       const ContactSettings& settings, double travel_limit_mm,
                       BoreOutcome& outcome) noexcept;

/// As far from the tip as point and shaft ask for bone, and as a turn of the tool is counted.
double shaft_reach_mm(const BoreTool& tool) noexcept;

}  // namespace hallux::simulator
