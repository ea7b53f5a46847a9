#include "ui/screens/instructor/attempts_screen.h"

#include <algorithm>
#include <array>

#include "ui/screens/parts/attempt_marks.h"
#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/card.h"

namespace hallux::ui {

namespace {

/// A course of years has a hundred thousand; older ones are on the pages of trainees and in histories.
constexpr std::int32_t shown_most = 500;

using database::AttemptHeader;

enum Column { Number, Operation, PersonColumn, Started, Kind, StateColumn, Score, ColumnCount };
constexpr float number_from = 540.0F, state_from = 700.0F, kind_from = 860.0F;

/// -1, 0 or 1: how two attempts stand to each other in a column.
int compared(const AttemptHeader& a, const AttemptHeader& b, int column) {
  const auto order = [](const auto& x, const auto& y) { return x < y ? -1 : (y < x ? 1 : 0); };
  switch (column) {
    case Operation:
      return order(a.scenario_name, b.scenario_name);
    case PersonColumn:
      return order(a.login, b.login);
    case Score:
      return order(a.score_milli, b.score_milli);
    default:
      return order(a.order, b.order);
  }
}

void draw_cell(Ui& ui, const AttemptHeader& attempt, int column, const Rect& cell) {
  const Theme& theme = ui.theme();
  const TextStyle plain{Type::Body, theme.text_secondary};
  switch (column) {
    case Number:
      ui.canvas().text_in(cell, {Type::Body, theme.text_caption, Align::Right},
                          grouped(static_cast<long>(attempt.order)));
      break;
    case Operation:
      ui.canvas().text_in(cell, {Type::BodyMedium, theme.text}, attempt.scenario_name, true);
      break;
    case PersonColumn:
      ui.canvas().text_in(
          cell, plain,
          attempt.begun.person ? std::string_view(attempt.login) : ui.text("attempts.robot"), true);
      break;
    case Started:
      ui.canvas().text_in(cell, plain, moment_text(attempt.started_utc));
      break;
    case Kind:
      ui.canvas().text_in(cell, plain, kind_text(ui, attempt));
      break;
    case StateColumn:
      draw_attempt_state(ui, attempt, cell);
      break;
    default:
      draw_attempt_score(ui, attempt, cell);
  }
}

}  // namespace

void AttemptsScreen::sort() {
  const TableSort& by = table_.sort;
  std::vector<AttemptHeader>& attempts = attempts_.value();
  std::stable_sort(attempts.begin(), attempts.end(),
                   [&](const AttemptHeader& a, const AttemptHeader& b) {
                     const int order = compared(a, b, by.column);
                     return by.is_descending || by.column < 0 ? order > 0 : order < 0;
                   });
}

void AttemptsScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  if (attempts_.is_new()) {
    attempts_.start(ui, shell, ui.text("attempts.reading"), [visit = visit_](WorkReport&) {
      return visit->in_turn(
          [](database::Session& session, auto&) { return session.attempts(shown_most); });
    });
  }
  Rect page = inset(content, space::page);
  const bool are_more = attempts_.has_value() && std::ssize(attempts_.value()) == shown_most;
  const std::string sentence =
      are_more ? ui.texts().say("attempts.sentence.newest", {{"count", grouped(shown_most)}})
               : std::string(ui.text("attempts.sentence"));
  page_title(ui, {page.x, page.y}, ui.text("attempts.title"), sentence);
  take_top(page, 76.0F);
  const Rect inside = card(ui, page, {});
  if (attempts_.draw_until_ready(ui, "attempts.failed", inside, 8)) draw_list(ui, inside);
}

void AttemptsScreen::draw_list(Ui& ui, const Rect& content) {
  if (attempts_.value().empty()) {
    empty_card(ui, "attempts.empty", content,
               {Icon::History, ui.text("attempts.empty"), ui.text("attempts.empty.sentence"), {}});
  } else {
    draw_table(ui, content);
  }
}

void AttemptsScreen::draw_table(Ui& ui, const Rect& content) {
  const std::array<TableColumn, ColumnCount> columns{{
      {ui.text("attempts.number"), 48.0F, 1.0F, Align::Right, true, number_from},
      {ui.text("attempts.operation"), 0.0F, 1.4F, Align::Left, true},
      {ui.text("attempts.person"), 0.0F, 1.0F, Align::Left, true},
      {ui.text("attempts.started"), 160.0F, 1.0F, Align::Left, true},
      {ui.text("attempts.kind"), 104.0F, 1.0F, Align::Left, false, kind_from},
      {ui.text("attempts.state"), 190.0F, 1.0F, Align::Left, false, state_from},
      {ui.text("attempts.score"), 88.0F, 1.0F, Align::Right, true},
  }};
  TableSpec spec;
  spec.columns = columns;
  spec.row_count = static_cast<int>(attempts_.value().size());
  spec.label = ui.text("attempts.title");
  const auto at = [this](int row) -> const AttemptHeader& {
    return attempts_.value()[static_cast<std::size_t>(row)];
  };
  spec.row_id = [&](int row) { return std::to_string(at(row).order); };
  spec.row_label = [&](int row) {
    return ui.texts().say("attempts.row", {{"operation", at(row).scenario_name},
                                           {"moment", moment_text(at(row).started_utc)}});
  };
  spec.draw_cell = [&](Ui& own, int row, int column, const Rect& cell) {
    draw_cell(own, at(row), column, cell);
  };
  const TableResponse response = table(ui, "attempts", content, spec, table_);
  if (response.has_sort_changed) sort();
  if (response.opened) places_.show_result(at(*response.opened).id);
}

}  // namespace hallux::ui
