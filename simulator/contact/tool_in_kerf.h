/// One tick of a blade in its kerf, and how it comes into one. Inside this corner only.
///
/// Part of tool_motion.h, and called by it alone.
#pragma once

#include "simulator/contact/tool_motion.h"

namespace hallux::simulator {

/// Moves the tool along the kerf's plane; through air, open kerf and aside by at most
/// `travel_limit_mm`.
void move_in_kerf(ToolState& tool, const ToolInput& input, const Wound& bone,
                  const ContactSettings& settings, double travel_limit_mm,
                  ToolOutcome& outcome) noexcept;

}  // namespace hallux::simulator
