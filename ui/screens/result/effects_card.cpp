// What the saw did beside the cut: facts, and curves over the strokes. Where none of it is scored
// the card says so on its head. Each fact names the moment to look at where there is one; the list
// of zones says whether any was watched, because "none touched" would mean nothing else.
#include "ui/screens/result/effects_card.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/report/effects_text.h"
#include "ui/screens/parts/attempt_timeline.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/chart_view.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr float two_columns_from = 780.0F, column_gap = 32.0F, shape_room = 22.0F,
                moment_room = 56.0F, least_row = 32.0F, empty_height = 180.0F, legend_gap = 8.0F;
/// The scale of heat begins at a round number below any bone, and ends at one.
constexpr double coolest_celsius = 20.0, celsius_step = 20.0;

/// One line: what, how much, and when to look.
struct EffectRow {
  std::string id;
  Meaning meaning = Meaning::Good;
  std::string name, value;
  std::optional<double> moment_s;
};

/// Beside the curves.
float facts_width(float width) noexcept { return std::min(400.0F, 0.42F * width); }

/// When the bone was hottest; nothing where it was never warm.
std::optional<double> hottest_moment_s(const Traces& traces) {
  const auto hottest = std::max_element(traces.points.begin(), traces.points.end(),
                                        [](const TracePoint& a, const TracePoint& b) {
                                          return a.hottest_celsius < b.hottest_celsius;
                                        });
  const bool was_warm =
      hottest != traces.points.end() && hottest->hottest_celsius > simulator::body_celsius;
  return was_warm ? std::optional(hottest->time_s) : std::nullopt;
}

std::optional<double> first_hot_s(const Traces& traces) {
  for (const TracePoint& point : traces.points)
    if (point.hottest_celsius > simulator::hot_celsius) return point.time_s;
  return std::nullopt;
}

std::optional<double> first_s(const std::vector<AttemptEvent>& events, std::string_view words) {
  for (const AttemptEvent& event : events)
    if (event.words == words) return event.time_s;
  return std::nullopt;
}

std::vector<EffectRow> heat_rows(const Texts& texts, const EffectFacts& effects) {
  const Traces& traces = effects.traces;
  const simulator::HeatSummary& heat = traces.heat;
  const Meaning heated = was_hot(heat) ? Meaning::Warn : Meaning::Good;
  const bool is_dead = heat.necrotic_mm3 > 0.0;
  const auto name = [&](const char* id) { return std::string(texts.text(id)); };
  return {{"hottest", heated, name("result.effects.hottest"), hottest_text(heat),
           hottest_moment_s(traces)},
          {"hot", heated, name("result.effects.hot"), hot_time_text(heat), first_hot_s(traces)},
          {"dead", is_dead ? Meaning::Bad : Meaning::Good, name("result.effects.dead"),
           is_dead ? dead_bone_text(heat) : name("result.effects.dead.none"),
           first_s(effects.events, "replay.event.bone_necrosis")},
          {"bend", Meaning::Info, name("result.effects.bend"),
           bend_text(traces.greatest_deflection_mm), std::nullopt}};
}

void add_zone_rows(std::vector<EffectRow>& rows, const Texts& texts,
                   const std::vector<ZoneContact>& zones) {
  const std::size_t before = rows.size();
  for (std::size_t zone = 0; zone < zones.size(); ++zone) {
    const ZoneContact& contact = zones[zone];
    if (contact.count == 0) continue;
    rows.push_back({"zone." + std::to_string(zone), Meaning::Bad, contact.title,
                    texts.say_count("result.effects.zone", contact.count,
                                    {{"time", contact_time_text(contact.duration_s)}}),
                    contact.first_s});
  }
  if (rows.size() > before) return;
  const char* answer =
      zones.empty() ? "result.effects.zones.unwatched" : "result.effects.zones.none";
  rows.push_back({"zones", zones.empty() ? Meaning::Neutral : Meaning::Good,
                  std::string(texts.text("result.effects.zones")), std::string(texts.text(answer)),
                  std::nullopt});
}

std::vector<EffectRow> rows_of(const Texts& texts, const EffectFacts& effects) {
  std::vector<EffectRow> rows = heat_rows(texts, effects);
  add_zone_rows(rows, texts, effects.zones);
  return rows;
}

float values_width(const Ui& ui, const std::vector<EffectRow>& rows) {
  float width = 0.0F;
  for (const EffectRow& row : rows)
    width = std::max(width, ui.width_of(Type::BodyStrong, row.value));
  return std::ceil(width) + 1.0F;
}

/// What the names have beside shape, value and moment.
float names_width(const Ui& ui, const std::vector<EffectRow>& rows, float width) {
  return std::max(60.0F, width - shape_room - values_width(ui, rows) - 16.0F - moment_room);
}

float row_height(const Ui& ui, const EffectRow& row, float name_width) {
  return std::max(least_row, ui.paragraph_height(Type::Small, row.name, name_width) + 12.0F);
}

float facts_height(const Ui& ui, const EffectFacts& effects, float width) {
  const std::vector<EffectRow> rows = rows_of(ui.texts(), effects);
  const float name_width = names_width(ui, rows, width);
  float height = 10.0F + ui.paragraph_height(Type::Small, ui.text("result.effects.models"), width);
  for (const EffectRow& row : rows) height += row_height(ui, row, name_width);
  return height;
}

std::optional<double> draw_facts(Ui& ui, Rect rest, const EffectFacts& effects) {
  const std::vector<EffectRow> rows = rows_of(ui.texts(), effects);
  const float name_width = names_width(ui, rows, rest.w), value_width = values_width(ui, rows);
  std::optional<double> asked_s;
  for (const EffectRow& row : rows) {
    Rect line = take_top(rest, row_height(ui, row, name_width));
    draw_meaning(ui.canvas(), ui.theme(), row.meaning, {line.x + 7.0F, line.mid_y()}, 6.0F);
    take_left(line, shape_room);
    const float words = ui.paragraph_height(Type::Small, row.name, name_width);
    ui.canvas().paragraph({line.x, line.mid_y() - 0.5F * words, name_width, words},
                          {Type::Small, ui.theme().text_secondary}, row.name);
    const Rect moment = take_right(line, moment_room);
    ui.canvas().text_in(take_right(line, value_width),
                        {Type::BodyStrong, ui.theme().text, Align::Right}, row.value);
    if (row.moment_s && link(ui, "result.effects." + row.id, {moment.right(), moment.mid_y()},
                             clock_text(*row.moment_s), Align::Right, Type::BodyMedium))
      asked_s = row.moment_s;
    ui.canvas().hairline_across(rest.x, rest.y, rest.w, ui.theme().line);
  }
  take_top(rest, 10.0F);
  ui.canvas().paragraph(rest, {Type::Small, ui.theme().text_caption},
                        ui.text("result.effects.models"));
  return asked_s;
}

Timeline timeline_of(const Ui& ui, const EffectFacts& effects, std::optional<double> moment_s) {
  Timeline shown{.duration_s = effects.duration_s,
                 .now_s = moment_s,
                 .steps_name = std::string(ui.text("replay.steps")),
                 .events_name = std::string(ui.text("replay.events")),
                 .steps = effects.steps};
  shown.events = event_marks_of(ui.texts(), effects.events);
  std::vector<ChartPoint> newton;
  TimelineTrack heat;
  for (const TracePoint& point : effects.traces.points) {
    newton.push_back({point.time_s, point.force_newton});
    heat.samples.push_back({point.time_s, point.hottest_celsius});
  }
  heat.name = ui.text("result.effects.heat");
  heat.unit = ui.text("result.effects.heat.unit");
  heat.low = coolest_celsius;
  heat.high = std::max(highest_of(heat.samples, celsius_step), 3.0 * celsius_step);
  heat.aim = simulator::hot_celsius;
  shown.tracks = {force_track(ui.texts(), std::move(newton)), std::move(heat)};
  shown.legend = legend_of(ui.texts(), {TimelineShape::Aim});
  return shown;
}

/// Closed until somebody asks what the marks mean.
bool shows_legend(const TimelineState& state) noexcept {
  return state.shows_legend.value_or(false);
}

float curves_width(float width) noexcept {
  return width >= two_columns_from ? width - facts_width(width) - column_gap : width;
}

float curves_height(const Ui& ui, const Timeline& shown, const TimelineState& state, float width) {
  const float legend = shows_legend(state)
                           ? timeline_legend_height(ui, shown, curves_width(width)) + legend_gap
                           : 0.0F;
  return timeline_bar_height + timeline_height(shown) + legend;
}

/// The curves with what zooms them above and what they mean below; returns the moment whose mark
/// was pressed.
std::optional<double> draw_curves(Ui& ui, Rect rest, const Timeline& shown, TimelineState& state) {
  timeline_bar(ui, "result.effects.time", take_top(rest, timeline_bar_height), shown, state,
               shows_legend(state));
  if (shows_legend(state))
    draw_timeline_legend(
        ui, take_bottom(rest, timeline_legend_height(ui, shown, rest.w), legend_gap), shown);
  // The wheel turns the page.
  const TimelineAnswer answer = timeline(ui, "result.effects.timeline", rest, shown, state, false);
  return answer.is_mark ? answer.asked_s : std::nullopt;
}

/// Facts beside the curves, or above them where the card is narrow.
struct EffectsPanes {
  Rect facts = {}, curves = {};
};

EffectsPanes panes_in(const Ui& ui, const Rect& rect, const EffectFacts& effects,
                      float curves_height) {
  if (rect.w >= two_columns_from) {
    const float facts = facts_width(rect.w);
    const float x = rect.x + facts + column_gap;
    return {{rect.x, rect.y, facts, facts_height(ui, effects, facts)},
            {x, rect.y, rect.right() - x, curves_height}};
  }
  const float facts = facts_height(ui, effects, rect.w);
  return {{rect.x, rect.y, rect.w, facts},
          {rect.x, rect.y + facts + space::between_cards, rect.w, curves_height}};
}

}  // namespace

float effects_height(const Ui& ui, const EffectFacts& effects, float width,
                     const TimelineState& state) {
  if (effects.traces.points.empty()) return empty_height;
  const float curves = curves_height(ui, timeline_of(ui, effects, {}), state, width);
  const EffectsPanes panes = panes_in(ui, {0.0F, 0.0F, width, 0.0F}, effects, curves);
  return std::max(panes.facts.bottom(), panes.curves.bottom());
}

std::optional<double> draw_effects(Ui& ui, const Rect& rect, const EffectFacts& effects,
                                   std::optional<double> moment_s, TimelineState& state) {
  if (effects.traces.points.empty()) {
    empty_card(
        ui, "result.effects.empty", rect,
        {Icon::History, ui.text("result.effects.empty"), ui.text("result.effects.empty.sentence")});
    return std::nullopt;
  }
  const Timeline shown = timeline_of(ui, effects, moment_s);
  const EffectsPanes panes = panes_in(ui, rect, effects, curves_height(ui, shown, state, rect.w));
  const std::optional<double> marked_s = draw_curves(ui, panes.curves, shown, state);
  const std::optional<double> linked_s = draw_facts(ui, panes.facts, effects);
  return linked_s ? linked_s : marked_s;
}

float effects_marks_width(const Ui& ui, bool is_scored) {
  const float reviewed = pill_width(ui, ui.text("result.mark.not_reviewed"));
  if (is_scored) return reviewed;
  return pill_width(ui, ui.text("result.effects.unscored"), false) + 8.0F + reviewed;
}

void draw_effects_marks(Ui& ui, const Rect& line, bool is_scored) {
  Point at{line.right() - effects_marks_width(ui, is_scored), line.mid_y()};
  if (!is_scored)
    at.x += pill(ui, at, ui.text("result.effects.unscored"), Meaning::Neutral, false) + 8.0F;
  pill(ui, at, ui.text("result.mark.not_reviewed"), Meaning::Warn);
}

}  // namespace hallux::ui
