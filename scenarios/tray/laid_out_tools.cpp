#include "scenarios/tray/laid_out_tools.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace hallux::scenarios {

namespace {

/// Of a small-bone tray; the lengths are ours.
constexpr double shortest_screw_mm = 10.0, longest_screw_mm = 40.0, screw_step_mm = 2.0;

/// "wire 1.25", "wire 2.0".
std::string sized(std::string_view kind, double diameter_mm) {
  std::array<char, 16> digits{};
  std::snprintf(digits.data(), digits.size(), "%.2f", diameter_mm);
  std::string size = digits.data();
  if (size.back() == '0') size.pop_back();
  return std::string(kind) + " " + size;
}

bool sets(const Scenario& scenario, ImplantKind kind) noexcept {
  return std::any_of(scenario.implants.begin(), scenario.implants.end(),
                     [kind](const Implant& implant) { return implant.kind == kind; });
}

void lay_out_blades(const Scenario& scenario, std::vector<LaidOutTool>& tools) {
  for (const BladeOffer& blade : scenario.blades) tools.push_back({blade.name, blade.saw});
  if (scenario.blades.empty()) tools.push_back({"blade", scenario.saw});
}

void lay_out_wires(std::vector<LaidOutTool>& tools) {
  for (const double diameter_mm : simulator::wire_diameters_mm) {
    simulator::WireDriver driver;
    driver.wire.diameter_mm = diameter_mm;
    tools.push_back({sized("wire", diameter_mm), driver});
  }
}

void lay_out_drills(std::vector<LaidOutTool>& tools) {
  for (const double diameter_mm : simulator::drill_diameters_mm) {
    simulator::Drill drill;
    drill.bit.diameter_mm = diameter_mm;
    tools.push_back({sized("drill", diameter_mm), drill});
  }
}

void lay_out_screws(std::vector<LaidOutTool>& tools) {
  for (const simulator::Screw& screw : simulator::cortical_screws) {
    for (double length_mm = shortest_screw_mm; length_mm <= longest_screw_mm;
         length_mm += screw_step_mm) {
      simulator::Screwdriver driver{.screw = screw};
      driver.screw.length_mm = length_mm;
      const std::string name = sized("screw", screw.thread_diameter_mm);
      tools.push_back({name + "x" + std::to_string(static_cast<int>(length_mm)), driver});
    }
  }
}

}  // namespace

std::vector<LaidOutTool> laid_out_tools(const Scenario& scenario) {
  std::vector<LaidOutTool> tools;
  lay_out_blades(scenario, tools);
  if (sets(scenario, ImplantKind::Wire)) lay_out_wires(tools);
  if (!sets(scenario, ImplantKind::Screw)) return tools;
  lay_out_drills(tools);
  lay_out_screws(tools);
  return tools;
}

simulator::Tray tray_of(const Scenario& scenario) {
  const std::vector<LaidOutTool> laid_out = laid_out_tools(scenario);
  std::vector<simulator::Tool> further;
  for (std::size_t i = 1; i < laid_out.size(); ++i) further.push_back(laid_out[i].tool);
  return {std::get<simulator::Saw>(laid_out.front().tool), further};
}

std::int32_t blade_place(const PlannedCut& cut) noexcept {
  return static_cast<std::int32_t>(cut.blade.value_or(0));
}

const simulator::Blade& blade_of(const Scenario& scenario, const PlannedCut& cut) noexcept {
  return cut.blade ? scenario.blades[*cut.blade].saw.blade : scenario.saw.blade;
}

std::optional<std::int32_t> place_of(const std::vector<LaidOutTool>& tools,
                                     std::string_view name) noexcept {
  const auto found = std::find_if(tools.begin(), tools.end(),
                                  [name](const LaidOutTool& tool) { return tool.name == name; });
  if (found == tools.end()) return std::nullopt;
  return static_cast<std::int32_t>(found - tools.begin());
}

}  // namespace hallux::scenarios
