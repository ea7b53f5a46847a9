// A scenario read out: about, steps, tray, scoring. Each part draws from the top of a long strip
// and says how high it was, so that height and drawing cannot differ. Every paragraph is a stop of
// the keyboard, since a page that only a wheel can scroll is closed to those without a mouse.
#include "ui/screens/trainee/briefing_text.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "assessment/number_text.h"
#include "assessment/pass_mark.h"
#include "assessment/shown_points.h"
#include "ui/screens/parts/value_text.h"
#include "ui/screens/trainee/briefing_tray.h"
#include "ui/widgets/charts/axis.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using scenarios::RubricItem;
using scenarios::Scenario;

constexpr float section_gap = 22.0F, number_room = 40.0F;
/// Of the names before facts, and between blocks of facts.
constexpr float fact_name_room = 92.0F, fact_gap = 3.0F, block_gap = 12.0F, block_title = 24.0F;
/// Of the picture.
constexpr float passes_height = 190.0F, passes_width = 320.0F;

/// Words that the keyboard can walk to, so that they can be scrolled into sight without a mouse.
void read_along(Ui& ui, std::string id, std::string_view label, const Rect& rect) {
  const Rect ring = inset(rect, -4.0F, -1.0F);
  if (ui.control({.id = std::move(id),
                  .label = std::string(label),
                  .rect = rect,
                  .role = Role::Row,
                  .group = "brief.words"})
          .shows_ring) {
    draw_focus_ring(ui.canvas(), ui.theme(), ring, radius::row);
  }
}

void draw_section(Ui& ui, Rect& rest, const char* id, std::string_view title,
                  std::string_view words) {
  const float height = ui.paragraph_height(Type::Body, words, rest.w);
  read_along(ui, id, title, {rest.x, rest.y, rest.w, 30.0F + height});
  ui.canvas().text_in(take_top(rest, 24.0F, 6.0F), {Type::BodyStrong, ui.theme().text}, title);
  ui.canvas().paragraph(take_top(rest, height, section_gap),
                        {Type::Body, ui.theme().text_secondary}, words);
}

std::string zones_text(const Texts& texts, const Scenario& scenario) {
  std::string zones;
  bool is_checked = true;
  for (const scenarios::DangerZone& zone : scenario.danger_zones) {
    if (!zones.empty()) zones += '\n';
    zones += zone.title;
    is_checked = is_checked && zone.is_checked;
  }
  return is_checked ? zones : texts.say("brief.zones.unchecked", {{"zones", zones}});
}

std::string means_text(const Texts& texts, const Scenario& scenario,
                       std::span<const PassesInView> passes) {
  std::string means = texts.say(has_tray(scenario) ? "brief.means.tray" : "brief.means.sentence",
                                {{"bone", file_name_text(scenario.patient.bone)},
                                 {"length", tick_text(scenario.patient.length_mm, 0.1)},
                                 {"blade", scenario.blade_name},
                                 {"rate", grouped(std::lround(scenario.saw.cycles_per_minute))}});
  const bool is_narrow = !std::ranges::all_of(passes, &PassesInView::is_one);
  return is_narrow ? means + " " + std::string(texts.text("brief.means.passes")) : means;
}

/// Of the cut that a step makes; null where it makes none, needs one pass, or is not known yet.
const PassesInView* passes_of(const Scenario& scenario, const scenarios::OperationStep& step,
                              std::span<const PassesInView> passes) {
  if (step.kind != scenarios::StepKind::Cut) return nullptr;
  for (std::size_t cut = 0; cut < std::min(passes.size(), scenario.cuts.size()); ++cut) {
    if (scenario.cuts[cut].name == step.cut && !passes[cut].is_one()) return &passes[cut];
  }
  return nullptr;
}

void draw_passes_of_step(Ui& ui, Rect& rest, const std::string& id, const PassesInView& passes) {
  const std::string words = passes_text(ui.texts(), passes);
  const float width = rest.w - number_room;
  const float height = ui.paragraph_height(Type::Small, words, width);
  Rect row = take_top(rest, height + 8.0F + passes_height, section_gap);
  read_along(ui, id, words, row);
  take_left(row, number_room);
  ui.canvas().paragraph(take_top(row, height, 8.0F), {Type::Small, ui.theme().text}, words);
  row.w = std::min(row.w, passes_width);
  ui.canvas().fill(row, ui.theme().raise, radius::row);
  draw_passes(ui, inset(row, 8.0F), passes);
}

/// A line with its points at the right.
void draw_points(Ui& ui, const Rect& line, std::string_view name, const std::string& points,
                 bool is_group) {
  const Theme& theme = ui.theme();
  Rect rest = line;
  const Type type = is_group ? Type::BodyStrong : Type::Small;
  const Color ink = is_group ? theme.text : theme.text_secondary;
  const float width = ui.width_of(type, points) + 1.0F;
  ui.canvas().text_in(take_right(rest, width, 12.0F), {type, ink, Align::Right}, points);
  if (!is_group) take_left(rest, 14.0F);
  ui.canvas().text_in(rest, {type, ink}, name, true);
}

bool is_measured(const Scenario& scenario, const scenarios::RubricGroup& group) {
  return std::any_of(scenario.rubric.items.begin(), scenario.rubric.items.end(),
                     [&](const RubricItem& item) { return item.group == group.name; });
}

/// The group's line and those of its items, with what they can give of 100 points, as the result
/// will say it.
void draw_group(Ui& ui, Rect& rest, const Scenario& scenario,
                const assessment::ShownWeights& weights, std::size_t index) {
  const scenarios::RubricGroup& group = scenario.rubric.groups[index];
  const Rect line = take_top(rest, 26.0F);
  read_along(ui, "brief.group." + group.name, group.title, line);
  const bool is_given = is_measured(scenario, group);
  draw_points(ui, line, group.title, is_given ? points_text(weights.groups_milli[index]) : "",
              true);
  if (!is_given) {
    pill(ui, {line.x + ui.width_of(Type::BodyStrong, group.title) + 12.0F, line.mid_y()},
         ui.text("brief.not_measured"), Meaning::Neutral, false);
  }
  for (std::size_t item = 0; item < scenario.rubric.items.size(); ++item) {
    if (scenario.rubric.items[item].group != group.name) continue;
    draw_points(ui, take_top(rest, 22.0F), scenario.rubric.items[item].title,
                points_text(weights.items_milli[item]), false);
  }
  if (is_given && group.not_measured_milli > 0)
    draw_points(ui, take_top(rest, 22.0F), ui.text("brief.group.rest"), "", false);
  take_top(rest, 8.0F);
}

void draw_gates(Ui& ui, Rect& rest, const Scenario& scenario) {
  if (scenario.rubric.gates.empty()) return;
  ui.canvas().hairline_across(rest.x, rest.y + 4.0F, rest.w, ui.theme().line);
  take_top(rest, 16.0F);
  ui.canvas().text_in(take_top(rest, 24.0F, 4.0F), {Type::BodyStrong, ui.theme().text},
                      ui.text("brief.gates"));
  for (const scenarios::Gate& gate : scenario.rubric.gates) {
    const Rect line = take_top(rest, 26.0F);
    read_along(ui, "brief.gate." + gate.name, gate.title, line);
    draw_meaning(ui.canvas(), ui.theme(), Meaning::Warn, {line.x + 8.0F, line.mid_y()}, 7.0F);
    ui.canvas().text_in(
        {line.x + 26.0F, line.y, line.w - 26.0F, line.h}, {Type::Small, ui.theme().text_secondary},
        ui.texts().say("brief.gate",
                       {{"gate", gate.title}, {"points", assessment::points_text(gate.cap_milli)}}),
        true);
  }
  take_top(rest, 8.0F);
}

// -- facts

float facts_height(const Ui& ui, const std::vector<Fact>& facts, float width) {
  float height = 0.0F;
  for (const Fact& fact : facts)
    height += ui.paragraph_height(Type::Small, fact.words, width - fact_name_room) + fact_gap;
  return height;
}

void draw_facts(Ui& ui, Rect rest, const std::vector<Fact>& facts) {
  const Theme& theme = ui.theme();
  const float width = rest.w - fact_name_room;
  for (const Fact& fact : facts) {
    Rect row = take_top(rest, ui.paragraph_height(Type::Small, fact.words, width), fact_gap);
    ui.canvas().paragraph(take_left(row, fact_name_room), {Type::Small, theme.text_caption},
                          fact.name);
    ui.canvas().paragraph(row, {Type::Small, theme.text_secondary}, fact.words);
  }
}

/// The title of a block, with its step at the right.
void draw_block_title(Ui& ui, Rect line, const FactBlock& block) {
  const Theme& theme = ui.theme();
  const float width = ui.width_of(Type::Caption, block.step) + 1.0F;
  ui.canvas().text_in(take_right(line, width, 12.0F),
                      {Type::Caption, theme.text_caption, Align::Right}, block.step);
  ui.canvas().text_in(line, {Type::BodyMedium, theme.text}, block.title, true);
}

void draw_group_of_facts(Ui& ui, Rect& rest, const FactGroup& group) {
  ui.canvas().text_in(take_top(rest, 24.0F, 4.0F), {Type::BodyStrong, ui.theme().text},
                      group.title);
  for (const FactBlock& block : group.blocks) {
    const float title = block.title.empty() ? 0.0F : block_title;
    Rect row = take_top(rest, title + facts_height(ui, block.facts, rest.w), block_gap);
    read_along(ui, block.id, block.title.empty() ? group.title : block.title, row);
    if (!block.title.empty()) draw_block_title(ui, take_top(row, block_title), block);
    draw_facts(ui, row, block.facts);
  }
  take_top(rest, section_gap - block_gap);
}

/// Where every height comes from: the strip is as tall as anything may become.
Rect endless(const Rect& rect) { return {rect.x, rect.y, rect.w, 100000.0F}; }

}  // namespace

float draw_about(Ui& ui, const Rect& rect, const Scenario& scenario,
                 std::span<const PassesInView> passes) {
  Rect rest = endless(rect);
  draw_section(ui, rest, "brief.indication", ui.text("brief.indication"), scenario.indication);
  draw_section(ui, rest, "brief.summary", ui.text("brief.summary"), scenario.summary);
  if (!scenario.danger_zones.empty()) {
    draw_section(ui, rest, "brief.zones", ui.text("brief.zones"), zones_text(ui.texts(), scenario));
  }
  draw_section(ui, rest, "brief.means", ui.text("brief.means"),
               means_text(ui.texts(), scenario, passes));
  return rest.y - rect.y;
}

float draw_steps(Ui& ui, const Rect& rect, const Scenario& scenario,
                 std::span<const PassesInView> passes) {
  Rect rest = endless(rect);
  const Theme& theme = ui.theme();
  int number = 0;
  for (const scenarios::OperationStep& step : scenario.steps) {
    ++number;
    const float width = rest.w - number_room;
    const float words = ui.paragraph_height(Type::Small, step.text, width);
    const Rect row = take_top(rest, 26.0F + words, 16.0F);
    read_along(ui, "brief.step." + std::to_string(number), step.title, row);
    const Point centre{row.x + 13.0F, row.y + 13.0F};
    ui.canvas().disc(centre, 13.0F, theme.chip);
    ui.canvas().text(centre, {Type::CaptionMedium, theme.text, Align::Centre},
                     std::to_string(number));
    ui.canvas().text_in({row.x + number_room, row.y, width, 26.0F}, {Type::BodyStrong, theme.text},
                        step.title, true);
    ui.canvas().paragraph({row.x + number_room, row.y + 26.0F, width, words},
                          {Type::Small, theme.text_secondary}, step.text);
    if (const PassesInView* narrow = passes_of(scenario, step, passes))
      draw_passes_of_step(ui, rest, "brief.passes." + std::to_string(number), *narrow);
  }
  draw_section(ui, rest, "brief.done", ui.text("brief.done"), ui.text("brief.done.rule"));
  return rest.y - rect.y;
}

float draw_tray(Ui& ui, const Rect& rect, const Scenario& scenario) {
  Rect rest = endless(rect);
  for (const FactGroup& group : tray_facts(ui.texts(), scenario))
    draw_group_of_facts(ui, rest, group);
  return rest.y - rect.y;
}

float draw_scoring(Ui& ui, const Rect& rect, const Scenario& scenario) {
  Rect rest = endless(rect);
  const assessment::ShownWeights weights = assessment::shown_weights(scenario.rubric);
  for (std::size_t group = 0; group < scenario.rubric.groups.size(); ++group)
    draw_group(ui, rest, scenario, weights, group);
  draw_gates(ui, rest, scenario);
  const std::string pass =
      ui.texts().say("brief.pass", {{"points", assessment::points_text(assessment::pass_milli)}});
  const float height = ui.paragraph_height(Type::Small, pass, rest.w);
  ui.canvas().paragraph(take_top(rest, height, 8.0F), {Type::Small, ui.theme().text_caption}, pass);
  return rest.y - rect.y;
}

}  // namespace hallux::ui
