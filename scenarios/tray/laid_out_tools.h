/// What an operation lays out: its blades, and where it sets wires or screws, a small-bone tray.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/plan.h"
#include "scenarios/scenario.h"
#include "simulator/tool/tray.h"

namespace hallux::scenarios {

struct LaidOutTool {
  /// Of a blade as the scenario says it; "wire 1.4", "drill 2.0", "screw 2.7x24".
  std::string name;
  simulator::Tool tool;
};

/// In their order on the tray: blades in the order of the file, then wires, drills and screws from
/// thin to thick and from short to long. Where no implant of a kind is set, none of it lies there;
/// drills lie beside screws.
std::vector<LaidOutTool> laid_out_tools(const Scenario& scenario);
simulator::Tray tray_of(const Scenario& scenario);

/// The planned blade of a cut: its place on the tray, and the blade; the first where none is.
std::int32_t blade_place(const PlannedCut& cut) noexcept;
const simulator::Blade& blade_of(const Scenario& scenario, const PlannedCut& cut) noexcept;

/// The place of the tool of that name, or nothing.
std::optional<std::int32_t> place_of(const std::vector<LaidOutTool>& tools,
                                     std::string_view name) noexcept;

}  // namespace hallux::scenarios
