/// The tools of a tray that set a planned wire or screw.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scenarios/fixation/planned_fixation.h"
#include "scenarios/tray/laid_out_tools.h"

namespace hallux::scenarios {

/// The place of the driver with the wire or screw that comes nearest to the plan; the diameter
/// counts before the length. Nothing where no such kind is laid out.
/// longer_mm  than planned
std::optional<std::int32_t> fitting_tool(const std::vector<LaidOutTool>& tools,
                                         const PlannedImplant& planned, double longer_mm = 0.0);

/// The place of the drill for the pilot hole of a tool's screw; nothing of what needs none.
std::optional<std::int32_t> pilot_drill(const std::vector<LaidOutTool>& tools, std::int32_t tool);

}  // namespace hallux::scenarios
