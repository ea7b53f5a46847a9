#include <array>
#include <cmath>
#include <vector>

#include "tests/ui/widgets/gallery.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/chart_view.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/navigation.h"
#include "ui/widgets/controls/picture_card.h"
#include "ui/widgets/controls/timeline_view.h"

namespace hallux::ui {
namespace {

using Words = std::string_view;

constexpr std::array<NavigationItem, 5> navigation_items{
    {{"nav.home", "Home", Icon::Home},
     {"nav.operations", "Operations", Icon::Operations},
     {"nav.history", "History", Icon::History},
     {"nav.messages", "Messages", Icon::Messages, 2},
     {"nav.data", "My data", Icon::Backup}}};

LineChart score_chart() {
  constexpr std::array scores{22.5, 31.0, 28.4, 44.0, 39.6, 52.3, 58.0,
                              49.5, 66.0, 63.8, 72.4, 81.4, 69.7, 76.8};
  constexpr std::array medians{22.5, 26.8, 28.4, 29.7, 31.0, 39.6, 44.0,
                               49.5, 52.3, 58.0, 63.8, 66.0, 69.7, 72.4};
  LineChart chart{"Points", "Attempt", 0.5, 16.5};
  chart.series = {{SeriesRole::You, "attempt", {}, false, true},
                  {SeriesRole::Median, "median of 5", {}}};
  for (std::size_t k = 0; k < scores.size(); ++k) {
    chart.series[0].points.push_back({static_cast<double>(k + 1), scores[k]});
    chart.series[1].points.push_back({static_cast<double>(k + 1), medians[k]});
  }
  chart.pass_mark = 70.0;
  chart.pass_name = "pass 70";
  return chart;
}

Timeline attempt_timeline() {
  Timeline shown;
  shown.duration_s = 236.0, shown.now_s = 151.4;
  shown.steps_name = "Steps", shown.events_name = "Events";
  shown.steps = {{0, 30, "Verify"},   {30, 46, "Mark"},     {46, 114, "Cut 1"},
                 {114, 180, "Cut 2"}, {180, 198, "Remove"}, {198, 222, "Close, fix"},
                 {222, 236, "End"}};
  shown.events = {{22},
                  {40},
                  {49, Meaning::Good},
                  {68, Meaning::Warn},
                  {78, Meaning::Bad},
                  {113, Meaning::Good},
                  {190, Meaning::Good}};
  shown.notes = {{52, "1"}, {151.4, "2"}, {182, "3"}};
  TimelineTrack force{"Force", "N, aim \xE2\x89\xA4 15", {}, 30.0, 15.0},
      plane{"To plane", "mm, aim \xE2\x89\xA4 0.5", {}, 10.0, 0.5};
  for (int k = 0; k <= 23600; ++k) {
    const double time_s = 0.01 * k, stroke = std::sin(time_s * 2.4);
    const bool is_cutting = (time_s > 48 && time_s < 112) || (time_s > 131 && time_s < 178);
    force.samples.push_back(
        {time_s,
         is_cutting ? 12.0 + 4.0 * stroke + (time_s > 77 && time_s < 79 ? 8.0 : 0.0) : 0.0});
    plane.samples.push_back(
        {time_s, is_cutting ? 0.4 + 0.3 * stroke * stroke : 4.0 + 3.0 * std::sin(time_s * 0.05)});
  }
  shown.tracks = {force, plane};
  return shown;
}

void draw_people(Ui& ui, const Rect& content, GalleryState& state) {
  constexpr std::array<Words, 3> pages{"Active 58", "Invited 4", "Disabled 2"};
  Rect rest = content;
  tabs(ui, "parts.tabs", take_top(rest, tabs_height, 4.0F), pages, state.tab);
  const Rect foot = take_bottom(rest, 40.0F, 8.0F);
  const std::array<TableColumn, 4> columns{{{"Name", 0.0F, 2.0F, Align::Left, 0.0F, true},
                                            {"Role", 0.0F, 1.2F},
                                            {"Attempts", 80.0F, 1.0F, Align::Right, 0.0F, true},
                                            {"Last seen", 0.0F, 1.2F}}};
  TableSpec spec;
  spec.columns = columns;
  spec.row_count = 58;
  spec.has_checkboxes = true;
  spec.label = "People";
  spec.row_id = [](int row) { return "person-" + std::to_string(row); };
  spec.row_label = [](int row) { return "Trainee " + std::to_string(row + 1); };
  spec.draw_cell = [](Ui& on, int row, int column, const Rect& cell) {
    const std::string name = "Trainee " + std::to_string(row + 1);
    Canvas& canvas = on.canvas();
    if (column == 0) {
      avatar(on, {cell.x + 13.0F, cell.mid_y()}, 13.0F, std::to_string(row + 1), row);
      canvas.text_in({cell.x + 34.0F, cell.y, cell.w - 34.0F, cell.h},
                     {Type::BodyMedium, on.theme().text}, name);
    }
    if (column == 1) canvas.text_in(cell, {Type::Body, on.theme().text}, "Trainee");
    if (column == 2)
      canvas.text_in(cell, {Type::Body, on.theme().text, Align::Right},
                     std::to_string(row * 3 + 1));
    if (column == 3) canvas.text_in(cell, {Type::Small, on.theme().text_secondary}, "yesterday");
  };
  table(ui, "parts.people", rest, spec, state.people);
  constexpr std::array<Words, 2> actions{"Add to cohort", "Disable"};
  if (!state.people.chosen.empty())
    action_bar(ui, "parts.actions", inset(foot, -12.0F, 0.0F),
               std::to_string(state.people.chosen.size()) + " chosen", actions, "58 people");
}

void draw_operation_cards(Ui& ui, const Rect& place) {
  PictureCardSpec spec{"Akin", "Closing wedge, proximal phalanx"};
  spec.difficulty = 2, spec.difficulty_word = "Easy";
  spec.competence = Competence::Learning, spec.progress = 0.5F, spec.state = "Learning, 6 of 12";
  spec.best_word = "best", spec.best = "81.4", spec.group = "parts.cards";
  picture_card(ui, "parts.akin", {place.x, place.y, picture_card_width, picture_card_height}, spec);
  PictureCardSpec silver{"Silver", "Medial eminence resection"};
  silver.difficulty_word = "Gentle", silver.state = "Not started", silver.group = "parts.cards";
  picture_card(ui, "parts.silver",
               {place.x + 295.0F, place.y, picture_card_width, picture_card_height}, silver);
}

void draw_message_rows(Ui& ui, const Rect& place) {
  Rect rest = card(ui, place, "What to take from this attempt");
  const MessageRow angle{
      Meaning::Warn, "You removed 12.3\xC2\xB0; the plan was 10.0\xC2\xB0",
      "The base was 3.1 mm at the medial cortex, plan 2.5. Measure it before cut 2, blade "
      "thickness included.",
      "5.2 points lost", "Drill: Measure the base"};
  message_row(ui, "parts.angle", take_top(rest, message_row_height(ui, angle, rest.w)), angle);
  ui.canvas().hairline_across(rest.x, rest.y, rest.w, ui.theme().line);
  const MessageRow inside{
      Meaning::Good, "The blade stayed inside the bone",
      "No plunge in any of 41 strokes, and no contact with the tendon or the joint.",
      "16 of 16 kept", "See 03:02"};
  message_row(ui, "parts.inside", take_top(rest, message_row_height(ui, inside, rest.w)), inside);
}

void draw_score(Ui& ui, const Rect& place) {
  card(ui, place, "");
  score_ring(ui, {place.x + 108.0F, place.y + 108.0F}, 72.0F,
             {"parts.ring", "76.8", "of 100", 0.768F, 0.70F});
  pill(ui, {place.x + 216.0F, place.y + 60.0F}, "Valid for grading", Meaning::Good);
  pill(ui, {place.x + 216.0F, place.y + 92.0F}, "Advisory until signed", Meaning::Neutral, false);
  pill(ui, {place.x + 216.0F, place.y + 124.0F}, "1 to look at", Meaning::Warn);
  pill(ui, {place.x + 216.0F, place.y + 156.0F}, "2 wrong", Meaning::Bad);
  constexpr std::array<NamedBar, 5> groups{{{"Accuracy", "34.7", "/ 50", 0.694F},
                                            {"Safety", "21.3", "/ 22", 0.968F},
                                            {"Tool use", "8.8", "/ 12", 0.733F},
                                            {"Procedure", "7.0", "/ 8", 0.875F},
                                            {"Efficiency", "5.0", "/ 8", 0.625F}}};
  float y = place.y + 214.0F;
  for (const NamedBar& group : groups) {
    named_bar(ui, {place.x + 20.0F, y, place.w - 40.0F, 24.0F}, group, 72.0F);
    y += 25.0F;
  }
}

}  // namespace

void draw_larger_parts(Ui& ui, GalleryState& state) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  NavigationSpec navigation;
  navigation.items = navigation_items;
  navigation.chosen = 2;
  navigation.who = {"Trainee 12", "Trainee", "12", 0};
  side_navigation(ui, navigation);
  const float left = navigation_width(ui, false);
  const Rect view{left, 0.0F, ui.display().w - left, ui.display().h};
  const float x = left + space::page,
              shift = -ui.begin_scroll("parts", "Larger parts", view, 1434.0F);
  page_title(ui, {x, 32.0F + shift}, "Larger parts", "Lists, cards, scores and charts.");
  filter_pill(ui, "parts.all", {x + 420.0F, 70.0F + shift}, "All 18", true);
  filter_pill(ui, "parts.idle", {x + 500.0F, 70.0F + shift}, "4 idle over 14 days", false);
  FieldSpec note{"Note", "What should be seen here?"};
  note.lines = 3;
  field(ui, "parts.note", {x, 128.0F + shift, 560.0F, 90.0F}, state.note, note);
  draw_people(ui, card(ui, {x, 240.0F + shift, 570.0F, 420.0F}, "People"), state);
  draw_operation_cards(ui, {x + 590.0F, 106.0F + shift, 0.0F, 0.0F});
  draw_score(ui, {x + 590.0F, 458.0F + shift, 400.0F, 346.0F});
  const Rect chart = card(ui, {x, 680.0F + shift, 570.0F, 434.0F}, "Score by attempt");
  line_chart(ui, "parts.chart", chart, score_chart(), [](std::size_t point) {
    return std::pair<std::string, std::string>{"Attempt " + std::to_string(point + 1),
                                               "24 Feb, 3:21"};
  });
  draw_message_rows(ui, {x + 590.0F, 824.0F + shift, 570.0F, 290.0F});
  const Rect times = card(ui, {x, 1134.0F + shift, 1160.0F, 280.0F}, "Replay");
  TimelineState times_state;
  timeline(ui, "parts.timeline", times, attempt_timeline(), times_state);
  ui.end_scroll();
}

}  // namespace hallux::ui
