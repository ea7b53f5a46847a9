// One's own attempts at an operation: chart, facts, list. Void attempts stand in the list and
// nowhere else. Medians run over one device class, and a guided hand does not count for them,
// because neither says how the person operates. A cohort is compared where enough people are in it;
// the desk decides that.
#include "ui/screens/trainee/history_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "simulator/base/units.h"
#include "ui/screens/parts/attempt_marks.h"
#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/value_text.h"
#include "ui/times/local_time.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

namespace {

constexpr float head_room = 100.0F, facts_width = 360.0F, chart_height = 404.0F;
constexpr float least_chart = 330.0F, least_table = 200.0F, control_gap = 16.0F;
constexpr int fewest_places = 12;  // the axis is no shorter: two points are no trend

std::vector<std::string> operation_names(const std::vector<OperationHistory>& histories) {
  std::vector<std::string> names;
  names.reserve(histories.size());
  for (const OperationHistory& history : histories) {
    names.push_back(operation_text(history.scenario_name));
  }
  return names;
}

ButtonSpec copy_button(const Ui& ui) {
  ButtonSpec spec{ui.text("history.copy"), ButtonLook::Secondary};
  spec.icon = Icon::Copy;
  return spec;
}

float controls_width(const Ui& ui, const std::vector<OperationHistory>& histories) {
  const std::vector<std::string> names = operation_names(histories);
  const std::vector<std::string_view> labels(names.begin(), names.end());
  return segmented_width(ui, labels) + control_gap + button_width(ui, copy_button(ui));
}

std::string duration_text(const database::AttemptHeader& attempt) {
  return attempt.duration_ticks ? clock_text(second_from_tick(*attempt.duration_ticks))
                                : std::string();
}

/// The points; where there are none, that an attempt which counts has no score.
void draw_score(Ui& ui, const JudgedAttempt& attempt, const Rect& cell) {
  const Theme& theme = ui.theme();
  if (attempt.score_milli) {
    ui.canvas().text_in(cell, {Type::BodyMedium, theme.text, Align::Right},
                        points_text(*attempt.score_milli));
  } else if (attempt.header.state != database::AttemptState::Void) {
    ui.canvas().text_in(cell, {Type::Small, theme.text_caption, Align::Right},
                        ui.text("attempts.not_scored"));
  }
}

/// A row is the attempt's place in the history.
std::vector<RowColumn<std::size_t>> columns_of(const Ui& ui, const OperationHistory& history) {
  const auto header = [&history](std::size_t row) -> const database::AttemptHeader& {
    return history.attempts[row].header;
  };
  return {
      {{ui.text("attempts.number"), 48.0F, 1.0F, Align::Right},
       [header](std::size_t row) { return grouped(static_cast<long>(header(row).number)); },
       caption_cell},
      {{ui.text("attempts.started"), 0.0F, 1.4F},
       [header](Ui& own, std::size_t row, const Rect& cell) {
         draw_moment_cell(own, cell, header(row).started_utc,
                          {Type::Body, own.theme().text_secondary});
       }},
      {{ui.text("attempts.kind")},
       [header, &ui](std::size_t row) { return std::string(kind_text(ui, header(row))); }},
      {{ui.text("attempts.state")},
       [header](Ui& own, std::size_t row, const Rect& cell) {
         draw_attempt_state(own, header(row), cell);
       }},
      {{ui.text("history.duration"), 90.0F, 1.0F, Align::Right},
       [header](std::size_t row) { return duration_text(header(row)); }},
      {{ui.text("attempts.score"), 88.0F, 1.0F, Align::Right},
       [&history](Ui& own, std::size_t row, const Rect& cell) {
         draw_score(own, history.attempts[row], cell);
       }},
  };
}

struct Fact {
  std::string name, value, note = {};
  /// A moment in place of the note.
  std::string noted_utc = {};
};

void draw_fact(Ui& ui, const Rect& rect, const Fact& fact) {
  const Theme& theme = ui.theme();
  const float top = rect.mid_y() - 31.0F;
  ui.canvas().text_in({rect.x, top, rect.w, 20.0F}, {Type::Small, theme.text_secondary}, fact.name,
                      true);
  ui.canvas().text_in({rect.x, top + 19.0F, rect.w, 26.0F}, {Type::Section, theme.text},
                      fact.value);
  const Rect note{rect.x, top + 45.0F, rect.w, 18.0F};
  const TextStyle style{Type::Caption, theme.text_caption};
  if (fact.noted_utc.empty()) {
    ui.canvas().text_in(note, style, fact.note, true);
  } else {
    draw_moment_cell(ui, note, fact.noted_utc, style);
  }
}

/// Best and last, the median, how many.
std::array<Fact, 4> facts_of(const Ui& ui, const OperationHistory& history) {
  const std::string nothing(ui.text("history.not_scored"));
  Fact best{std::string(ui.text("history.best")), nothing}, last = best, median = best;
  last.name = ui.text("history.last");
  median.name = ui.text("history.median");
  median.note = ui.text("history.median.note");
  std::int64_t best_milli = -1;
  long assessments = 0;
  for (std::size_t number = 0; number < history.counted.size(); ++number) {
    const JudgedAttempt& attempt = history.attempts[history.counted[number]];
    if (attempt.header.begun.kind == database::AttemptKind::Assessment) ++assessments;
    if (!attempt.score_milli) continue;
    last.value = points_text(*attempt.score_milli);
    last.noted_utc = attempt.header.started_utc;
    if (const double points = history.medians[number].y; !std::isnan(points))
      median.value = points_text(std::llround(points * 1000.0));
    if (*attempt.score_milli <= best_milli) continue;
    best_milli = *attempt.score_milli;
    best.value = last.value;
    best.noted_utc = last.noted_utc;
  }
  const auto count = static_cast<long>(history.counted.size());
  const Fact attempts{std::string(ui.text("history.attempts")), grouped(count),
                      ui.texts().say("history.kinds", {{"practice", grouped(count - assessments)},
                                                       {"assessment", grouped(assessments)}})};
  return {best, last, median, attempts};
}

void compare(database::TraineeDesk& desk, OperationHistory& history) {
  if (history.counted.empty()) return;
  const std::string& device_class =
      history.attempts[history.counted.back()].header.begun.device_class;
  for (database::CohortComparison& comparison : desk.cohort_comparisons(history.scenario_name)) {
    if (comparison.device_class != device_class) continue;
    history.cohort = std::move(comparison);
    return;
  }
}

std::vector<OperationHistory> read_histories(database::Session& session) {
  std::vector<OperationHistory> histories = histories_of(own_attempts(session));
  database::TraineeDesk desk = trainee_of(session);
  for (OperationHistory& history : histories) compare(desk, history);
  return histories;
}

/// The median, and what the middle half of the people has.
Fact cohort_fact(const Ui& ui, const database::CohortComparison& cohort) {
  const std::string people = std::to_string(cohort.people);
  Fact fact{ui.texts().say("history.cohort", {{"cohort", cohort.cohort_name}}),
            points_text(cohort.median_milli),
            {}};
  if (cohort.lower_milli && cohort.upper_milli) {
    fact.note =
        ui.texts().say("history.cohort.quartiles", {{"people", people},
                                                    {"lower", points_text(*cohort.lower_milli)},
                                                    {"upper", points_text(*cohort.upper_milli)}});
  } else {
    fact.note = ui.texts().say("history.cohort.median", {{"people", people}});
  }
  return fact;
}

/// As many blocks as clean runs are needed, those that there are in the accent.
void draw_evidence(Ui& ui, const Rect& rect, const assessment::LearningState& learning) {
  const int needed = assessment::clean_runs_needed(), runs = learning.clean_runs();
  const Fact fact{std::string(ui.text("history.clean_runs")),
                  ui.texts().say("history.clean_runs.value", {{"runs", std::to_string(runs)},
                                                              {"needed", std::to_string(needed)}}),
                  std::string(ui.text(learning.is_competent  ? "history.clean_runs.competent"
                                      : learning.has_slipped ? "history.clean_runs.slipped"
                                                             : "history.clean_runs.note"))};
  draw_fact(ui, {rect.x, rect.y, rect.w, rect.h - 14.0F}, fact);
  const Rect strip{rect.x, rect.bottom() - 10.0F, rect.w, 8.0F};
  const std::vector<Rect> blocks = columns(strip, needed, 4.0F);
  for (int number = 0; number < needed; ++number) {
    ui.canvas().fill(blocks[static_cast<std::size_t>(number)],
                     number < runs ? ui.theme().accent : ui.theme().chip, 3.0F);
  }
}

}  // namespace

const OperationHistory& HistoryScreen::history() const {
  const auto last = histories_.value().size() - 1;
  return histories_.value()[std::min(static_cast<std::size_t>(chosen_), last)];
}

void HistoryScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  histories_.read(ui, shell, ui.text("history.reading"), signed_in_, read_histories);
  PageHead head =
      course_head(ui, *signed_in_, ui.text("history.title"), ui.text("history.sentence"));
  const bool has_attempts = histories_.has_value() && !histories_.value().empty();
  if (has_attempts) head.buttons_width = controls_width(ui, histories_.value());
  const bool is_narrow = are_panes_stacked(content.w - 2.0F * page_margin(content));
  const float top = is_narrow ? 2.0F * least_chart + space::between_cards : least_chart;
  const Page page(ui, "history", head.title, content,
                  head_room + top + space::between_cards + least_table);
  Rect rest = page.rect();
  const Rect controls = page_head(ui, "history", rest, head).buttons;
  if (!histories_.draw_until_ready(ui, "history.failed", rest, 8)) return;
  if (!has_attempts) {
    empty_card(ui, "history.empty", rest,
               {Icon::History, ui.text("history.empty"), ui.text("history.empty.sentence")});
    return;
  }
  draw_controls(ui, controls, shell);
  draw_history(ui, rest);
}

void HistoryScreen::draw_controls(Ui& ui, const Rect& controls, Shell& shell) {
  const std::vector<std::string> names = operation_names(histories_.value());
  const std::vector<std::string_view> labels(names.begin(), names.end());
  Rect rest = controls;
  const ButtonSpec spec = copy_button(ui);
  const Rect copy_place = take_right(rest, button_width(ui, spec), control_gap);
  segmented(ui, "history.operation", rest, labels, chosen_);
  const bool is_pressed = button(ui, "history.copy", copy_place, spec);
  if (ui.shortcut(with_control(Key::C), ui.text("history.copy.shortcut")) || is_pressed) {
    copy(ui, shell);
  }
}

void HistoryScreen::copy(Ui& ui, Shell& shell) const {
  ui.clipboard().write(csv_of(history()));
  shell.say({Meaning::Good,
             ui.texts().say_count("history.copied", static_cast<long>(history().counted.size())),
             std::string(ui.text("history.copied.detail"))});
  ui.want_frame_in_s(0.0);
}

void HistoryScreen::draw_history(Ui& ui, Rect page) {
  const float gap = space::between_cards;
  if (are_panes_stacked(page.w)) {
    draw_chart(ui, take_top(page, least_chart, gap));
    draw_facts(ui, take_top(page, least_chart, gap));
  } else {
    const float height = std::clamp(page.h - gap - least_table, least_chart, chart_height);
    Rect top = take_top(page, height, gap);
    draw_facts(ui, take_right(top, facts_width, gap));
    draw_chart(ui, top);
  }
  draw_attempts(ui, page);
}

void HistoryScreen::draw_chart(Ui& ui, const Rect& rect) {
  const OperationHistory& shown = history();
  const Rect inside = card(ui, rect, ui.text("history.chart"));
  LineChart chart;
  chart.y_unit = ui.text("history.points");
  chart.x_name = ui.text("history.attempt_axis");
  chart.x_low = 0.5;
  chart.x_high = 0.5 + fewest_places;
  for (const ChartPoint& point : shown.scores) chart.x_high = std::max(chart.x_high, point.x + 0.5);
  chart.series = {
      {SeriesRole::You, std::string(ui.text("history.series.you")), shown.scores, false, true},
      {SeriesRole::Median, std::string(ui.text("history.series.median")), shown.medians}};
  chart.pass_mark = static_cast<double>(assessment::pass_milli) / 1000.0;
  chart.pass_name =
      ui.texts().say("history.pass", {{"points", std::to_string(assessment::pass_milli / 1000)}});
  const auto words = [&](std::size_t point) {
    const JudgedAttempt& attempt = shown.attempts[shown.counted[point]];
    return std::pair(
        ui.texts().say("history.point", {{"points", points_text(*attempt.score_milli)}}),
        ui.texts().say("history.point.context",
                       {{"number", std::to_string(attempt.header.number)},
                        {"moment", full_moment_text(attempt.header.started_utc)},
                        {"kind", std::string(kind_text(ui, attempt.header))}}));
  };
  // The legend stands in the line of the title.
  const Rect plot{inside.x, inside.y - 32.0F, inside.w, inside.h + 32.0F};
  const auto pressed = line_chart(ui, "history.chart", plot, chart, words);
  if (pressed) navigator_.show_result(shown.attempts[shown.counted[*pressed]].header.id);
}

void HistoryScreen::draw_facts(Ui& ui, const Rect& rect) const {
  Rect inside = card(ui, rect, ui.text("history.facts"));
  const std::array<Fact, 4> facts = facts_of(ui, history());
  const float step = inside.h / 3.0F;
  for (std::size_t row = 0; row < 2; ++row) {
    const Rect line = take_top(inside, step);
    const std::vector<Rect> places = columns(line, 2, 12.0F);
    draw_fact(ui, places[0], facts[2 * row]);
    draw_fact(ui, places[1], facts[2 * row + 1]);
    ui.canvas().hairline_across(line.x, line.bottom(), line.w, ui.theme().line);
  }
  if (history().cohort) {
    const std::vector<Rect> places = columns(inside, 2, 12.0F);
    draw_evidence(ui, places[0], history().learning);
    draw_fact(ui, {places[1].x, places[1].y, places[1].w, places[1].h - 14.0F},
              cohort_fact(ui, *history().cohort));
  } else {
    draw_evidence(ui, inside, history().learning);
  }
}

void HistoryScreen::draw_attempts(Ui& ui, const Rect& rect) {
  const OperationHistory& shown = history();
  const Rect inside = card(ui, rect, ui.text("history.list"));
  std::vector<std::size_t> newest_first(shown.attempts.size());
  std::iota(newest_first.rbegin(), newest_first.rend(), std::size_t{0});
  const RowTable<std::size_t> list{
      ui.text("history.list"),
      [&](std::size_t row) { return std::to_string(shown.attempts[row].header.order); },
      [&](std::size_t row) { return attempt_name(ui.texts(), shown.attempts[row].header); },
      columns_of(ui, shown)};
  const TableResponse response = table(ui, "history.list", inside, list, newest_first, table_);
  if (!response.opened) return;
  const std::size_t opened = newest_first[static_cast<std::size_t>(*response.opened)];
  navigator_.show_result(shown.attempts[opened].header.id);
}

}  // namespace hallux::ui
