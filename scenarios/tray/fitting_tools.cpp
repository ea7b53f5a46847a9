#include "scenarios/tray/fitting_tools.h"

#include <cmath>
#include <variant>

namespace hallux::scenarios {

namespace {

double middle_off(double value, const Range& range) noexcept {
  return std::abs(value - range.middle_mm());
}

/// How far a tool is from what the plan asks; nothing of a tool of another kind.
std::optional<double> misfit_of(const simulator::Tool& tool, const PlannedImplant& planned,
                                double longer_mm) {
  if (const auto* wire = std::get_if<simulator::WireDriver>(&tool)) {
    if (planned.kind != ImplantKind::Wire) return std::nullopt;
    return middle_off(wire->wire.diameter_mm, planned.diameters);
  }
  const auto* driver = std::get_if<simulator::Screwdriver>(&tool);
  if (driver == nullptr || planned.kind != ImplantKind::Screw) return std::nullopt;
  // The diameter is chosen before the length.
  constexpr double before = 100.0;
  return before * middle_off(driver->screw.thread_diameter_mm, planned.diameters) +
         std::abs(driver->screw.length_mm - planned.length_mm - longer_mm);
}

}  // namespace

std::optional<std::int32_t> fitting_tool(const std::vector<LaidOutTool>& tools,
                                         const PlannedImplant& planned, double longer_mm) {
  std::optional<std::size_t> best;
  double best_off = 0.0;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const std::optional<double> off = misfit_of(tools[i].tool, planned, longer_mm);
    if (!off || (best && *off >= best_off)) continue;
    best = i;
    best_off = *off;
  }
  if (!best) return std::nullopt;
  return static_cast<std::int32_t>(*best);
}

std::optional<std::int32_t> pilot_drill(const std::vector<LaidOutTool>& tools, std::int32_t tool) {
  const auto* driver =
      std::get_if<simulator::Screwdriver>(&tools[static_cast<std::size_t>(tool)].tool);
  if (driver == nullptr) return std::nullopt;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const auto* drill = std::get_if<simulator::Drill>(&tools[i].tool);
    if (drill != nullptr && drill->bit.diameter_mm == driver->screw.pilot_diameter_mm)
      return static_cast<std::int32_t>(i);
  }
  return std::nullopt;
}

}  // namespace hallux::scenarios
