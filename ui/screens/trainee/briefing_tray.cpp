// What is laid out and planned, put into words. A planned size is a range, of which the tray has
// one tool or several: those are named, so that nobody has to look for what fits meanwhile.
#include "ui/screens/trainee/briefing_tray.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "scenarios/steps/step_order.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/units.h"
#include "ui/screens/parts/value_text.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

using scenarios::Implant;
using scenarios::ImplantKind;
using scenarios::LaidOutTool;
using scenarios::Scenario;

/// Each once, with commas between.
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(names.begin(), name, *name) != name) continue;
    text += (text.empty() ? "" : ", ") + *name;
  }
  return text;
}

std::string range_text(const Texts& texts, const scenarios::Range& range) {
  const std::string low = short_text(range.low_mm), high = short_text(range.high_mm);
  return low == high ? low : texts.say("brief.range", {{"low", low}, {"high", high}});
}

bool is_within(double value_mm, const scenarios::Range& range) noexcept {
  constexpr double rounding_mm = 1.0e-6;
  return value_mm > range.low_mm - rounding_mm && value_mm < range.high_mm + rounding_mm;
}

/// Diameters of the wires.
/// implant  whose planned range they are in; null: all
std::vector<std::string> wires_of(const std::vector<LaidOutTool>& tools,
                                  const Implant* implant = nullptr) {
  std::vector<std::string> diameters;
  for (const LaidOutTool& each : tools) {
    const auto* driver = std::get_if<simulator::WireDriver>(&each.tool);
    if (driver == nullptr) continue;
    const double diameter_mm = driver->wire.diameter_mm;
    if (implant == nullptr || is_within(diameter_mm, implant->diameter))
      diameters.push_back(short_text(diameter_mm));
  }
  return diameters;
}

/// Screws of one diameter, from short to long, with the drill of their hole.
struct ScrewSizes {
  std::string diameter, drill;
  std::vector<std::string> lengths;
};

/// implant  whose planned ranges they are in; null: all
std::vector<ScrewSizes> screws_of(const std::vector<LaidOutTool>& tools,
                                  const Implant* implant = nullptr) {
  std::vector<ScrewSizes> sizes;
  for (const LaidOutTool& each : tools) {
    const auto* driver = std::get_if<simulator::Screwdriver>(&each.tool);
    if (driver == nullptr) continue;
    const auto& screw = driver->screw;
    if (implant != nullptr && !(is_within(screw.thread_diameter_mm, implant->diameter) &&
                                is_within(screw.length_mm, implant->length)))
      continue;
    const std::string diameter = short_text(screw.thread_diameter_mm);
    if (sizes.empty() || sizes.back().diameter != diameter)
      sizes.push_back({diameter, short_text(screw.pilot_diameter_mm), {}});
    sizes.back().lengths.push_back(short_text(screw.length_mm));
  }
  return sizes;
}

std::vector<std::string> drills_of(const std::vector<LaidOutTool>& tools) {
  std::vector<std::string> diameters;
  for (const LaidOutTool& each : tools) {
    if (const auto* drill = std::get_if<simulator::Drill>(&each.tool))
      diameters.push_back(short_text(drill->bit.diameter_mm));
  }
  return diameters;
}

std::string blade_text(const Texts& texts, const Scenario& scenario,
                       const scenarios::BladeOffer& blade) {
  std::vector<std::string> cuts;
  for (const scenarios::ReferenceCut& cut : scenario.cuts)
    if (cut.blade == blade.name) cuts.push_back(cut.title);
  if (cuts.empty()) return blade.title;
  return texts.say("brief.laid_out.blade.for", {{"blade", blade.title}, {"cuts", listed(cuts)}});
}

FactBlock tray_block(const Texts& texts, const Scenario& scenario,
                     const std::vector<LaidOutTool>& tools) {
  FactBlock block{"brief.laid_out", {}, {}, {}};
  const auto add = [&](std::string_view id, std::string words) {
    block.facts.push_back({texts.text(id), std::move(words)});
  };
  const auto thick = [&](const std::vector<std::string>& diameters) {
    return texts.say("brief.laid_out.thick", {{"diameters", listed(diameters)}});
  };
  for (const scenarios::BladeOffer& blade : scenario.blades)
    add("brief.laid_out.blade", blade_text(texts, scenario, blade));
  if (const auto wires = wires_of(tools); !wires.empty()) add("brief.laid_out.wires", thick(wires));
  if (const auto drills = drills_of(tools); !drills.empty())
    add("brief.laid_out.drills", thick(drills));
  for (const ScrewSizes& screws : screws_of(tools)) {
    add("brief.laid_out.screws",
        texts.say("brief.laid_out.screws.sizes", {{"diameter", screws.diameter},
                                                  {"shortest", screws.lengths.front()},
                                                  {"longest", screws.lengths.back()}}));
  }
  if (!scenario.shifts.empty())
    add("brief.laid_out.forceps", std::string(texts.text("brief.laid_out.forceps.always")));
  return block;
}

/// "Step 11".
std::string step_text(const Texts& texts, const Scenario& scenario,
                      const scenarios::OperationStep& step) {
  return texts.say("brief.at_step",
                   {{"number", std::to_string(&step - scenario.steps.data() + 1)}});
}

/// The other steps of its group, of which one suffices; empty where it has none.
std::string instead_of(const Scenario& scenario, const scenarios::OperationStep& step) {
  const auto own = static_cast<std::size_t>(&step - scenario.steps.data());
  std::vector<std::string> others;
  for (const std::size_t other : alternatives_of(scenario, own))
    if (other != own) others.push_back(scenario.steps[other].title);
  return listed(others);
}

/// The side that a direction looks to as its author laid it: "lateral" of what was laid square to
/// the shaft from lateral; empty where it was made otherwise.
std::string side_of(const Scenario& scenario, std::string name) {
  for (std::size_t i = 0; i <= scenario.directions.size(); ++i) {
    const auto found =
        std::ranges::find(scenario.directions, name, &scenarios::NamedDirection::name);
    if (found == scenario.directions.end()) return file_name_text(name);
    if (found->kind != scenarios::DirectionKind::LaidSquare) return {};
    name = found->first;
  }
  return {};
}

std::string move_text(const Texts& texts, const Scenario& scenario,
                      const scenarios::FragmentMove& move) {
  if (move.is_turn) {
    const double turn_deg = degree_from_radian(std::abs(move.turn_rad));
    return texts.say("brief.shift.turn", {{"angle", short_text(turn_deg)}});
  }
  const std::string way = short_text(std::abs(move.slide_mm));
  const std::string side = side_of(scenario, move.direction);
  if (side.empty() || move.slide_mm < 0.0) return texts.say("brief.shift.slide", {{"way", way}});
  return texts.say("brief.shift.slide_to", {{"way", way}, {"side", side}});
}

/// A fragment's title, or the name of a bone, which begins as a title does.
std::string part_text(const Scenario& scenario, const std::string& name) {
  const auto fragment = std::ranges::find(scenario.fragments, name, &scenarios::Fragment::name);
  if (fragment != scenario.fragments.end()) return fragment->title;
  std::string bone = file_name_text(name);
  if (bone.front() >= 'a' && bone.front() <= 'z')
    bone.front() = static_cast<char>(bone.front() - 'a' + 'A');
  return bone;
}

std::vector<FactBlock> shift_blocks(const Texts& texts, const Scenario& scenario) {
  std::vector<FactBlock> blocks;
  for (const scenarios::FragmentShift& shift : scenario.shifts) {
    FactBlock& block = blocks.emplace_back();
    block.id = "brief.shift." + shift.name;
    block.title = shift.title;
    const auto step =
        std::ranges::find(scenario.steps, shift.name, &scenarios::OperationStep::shift);
    if (step != scenario.steps.end()) block.step = step_text(texts, scenario, *step);
    std::vector<std::string> moves;
    for (const scenarios::FragmentMove& move : shift.moves)
      moves.push_back(move_text(texts, scenario, move));
    block.facts = {{texts.text("brief.fact.fragment"), part_text(scenario, shift.fragment)},
                   {texts.text("brief.fact.way"), listed(moves)}};
    if (shift.is_closed)
      block.facts.push_back(
          {texts.text("brief.fact.then"), std::string(texts.text("brief.shift.close"))});
  }
  return blocks;
}

std::string size_text(const Texts& texts, const Implant& implant) {
  return texts.say(implant.kind == ImplantKind::Wire ? "brief.implant.wire" : "brief.implant.screw",
                   {{"diameters", range_text(texts, implant.diameter)},
                    {"lengths", range_text(texts, implant.length)}});
}

std::string holds_text(const Texts& texts, const Scenario& scenario, const Implant& implant) {
  std::vector<std::string> parts;
  for (const std::string& name : implant.engages) parts.push_back(part_text(scenario, name));
  return texts.say_count("brief.implant.holds", implant.cortices, {{"parts", listed(parts)}});
}

/// Each a tool, or several of which one suffices, that fits; empty where none does.
std::vector<std::string> fitting_texts(const Texts& texts, const std::vector<LaidOutTool>& tools,
                                       const Implant& implant) {
  std::vector<std::string> fitting;
  if (implant.kind == ImplantKind::Wire) {
    if (const auto wires = wires_of(tools, &implant); !wires.empty())
      fitting.push_back(texts.say("brief.implant.take.wire", {{"diameters", listed(wires)}}));
    return fitting;
  }
  for (const ScrewSizes& screws : screws_of(tools, &implant)) {
    fitting.push_back(texts.say("brief.implant.take.screw", {{"drill", screws.drill},
                                                             {"diameter", screws.diameter},
                                                             {"lengths", listed(screws.lengths)}}));
  }
  return fitting;
}

std::string clear_text(const Texts& texts, const Scenario& scenario,
                       const scenarios::ImplantClearance& clear) {
  const auto surface = std::ranges::find(scenario.joint_surfaces, clear.joint_surface,
                                         &scenarios::JointSurface::name);
  const std::string joint = surface == scenario.joint_surfaces.end()
                                ? file_name_text(clear.joint_surface)
                                : surface->title;
  return texts.say("brief.implant.clear", {{"joint", joint}, {"way", short_text(clear.least_mm)}});
}

std::vector<Fact> implant_facts(const Texts& texts, const Scenario& scenario,
                                const std::vector<LaidOutTool>& tools, const Implant& implant) {
  std::vector<Fact> facts;
  const auto add = [&](std::string_view id, std::string words) {
    facts.push_back({texts.text(id), std::move(words)});
  };
  add("brief.fact.size", size_text(texts, implant));
  std::string_view take = "brief.fact.take";
  for (std::string& fitting : fitting_texts(texts, tools, implant)) {
    add(take, std::move(fitting));
    take = "brief.fact.or_take";
  }
  add("brief.fact.holds", holds_text(texts, scenario, implant));
  for (const scenarios::ImplantClearance& clear : implant.clear_of)
    add("brief.fact.clear", clear_text(texts, scenario, clear));
  if (implant.is_temporary)
    add("brief.fact.after", std::string(texts.text("brief.implant.temporary")));
  return facts;
}

std::vector<FactBlock> implant_blocks(const Texts& texts, const Scenario& scenario,
                                      const std::vector<LaidOutTool>& tools) {
  std::vector<FactBlock> blocks;
  for (const Implant& implant : scenario.implants) {
    FactBlock& block = blocks.emplace_back();
    block.id = "brief.implant." + implant.name;
    block.title = implant.title;
    block.facts = implant_facts(texts, scenario, tools, implant);
    const auto step = std::ranges::find_if(scenario.steps, [&](const auto& each) {
      return std::ranges::find(each.implants, implant.name) != each.implants.end();
    });
    if (step == scenario.steps.end()) continue;
    block.step = step_text(texts, scenario, *step);
    if (std::string others = instead_of(scenario, *step); !others.empty())
      block.facts.push_back({texts.text("brief.fact.instead"), std::move(others)});
  }
  return blocks;
}

}  // namespace

bool has_tray(const Scenario& scenario) noexcept {
  return scenario.blades.size() > 1 || !scenario.shifts.empty() || !scenario.implants.empty();
}

std::vector<FactGroup> tray_facts(const Texts& texts, const Scenario& scenario) {
  const std::vector<LaidOutTool> tools = laid_out_tools(scenario);
  std::vector<FactGroup> groups;
  const auto add = [&](std::string_view title, std::vector<FactBlock> blocks) {
    if (!blocks.empty()) groups.push_back({texts.text(title), std::move(blocks)});
  };
  add("brief.laid_out", {tray_block(texts, scenario, tools)});
  add("brief.shifts", shift_blocks(texts, scenario));
  add("brief.implants", implant_blocks(texts, scenario, tools));
  return groups;
}

}  // namespace hallux::ui
