/// One tick of a tool that is in no kerf: free in air, or held out of the bone by its teeth, faces
/// and edges. Inside this corner only.
///
/// Part of tool_motion.h, and called by it alone.
#pragma once

#include "simulator/contact/tool_motion.h"

namespace hallux::simulator {

/// The way of the blade's points in a motion, at most [mm].
double reach_of(const ProxyMotion& motion, const Blade& blade) noexcept;

/// Moves the tool by at most `travel_limit_mm`. In Touching running teeth are fed into the bone.
void move_outside(ToolState& tool, const ToolInput& input, const Wound& bone,
                  const ContactSettings& settings, double travel_limit_mm,
                  ToolOutcome& outcome) noexcept;

}  // namespace hallux::simulator
