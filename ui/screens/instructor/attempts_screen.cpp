#include "ui/screens/instructor/attempts_screen.h"

#include "ui/screens/parts/attempt_marks.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/value_text.h"
#include "ui/times/local_time.h"
#include "ui/widgets/controls/card.h"

namespace hallux::ui {

namespace {

/// A course of years has a hundred thousand; older ones are on the pages of trainees and in
/// histories.
constexpr std::int32_t shown_most = 500;

using database::AttemptHeader;

constexpr float number_from = 540.0F, state_from = 700.0F, kind_from = 860.0F;

std::string person_of(const Ui& ui, const AttemptHeader& attempt) {
  return attempt.begun.person ? attempt.login : std::string(ui.text("attempts.robot"));
}

std::vector<RowColumn<AttemptHeader>> columns_of(const Ui& ui) {
  using Attempt = const AttemptHeader&;
  const auto order = by(&AttemptHeader::order);
  return {
      {{ui.text("attempts.number"), 48.0F, 1.0F, Align::Right, number_from},
       [](Attempt attempt) { return grouped(static_cast<long>(attempt.number)); },
       caption_cell,
       by(&AttemptHeader::number)},
      {{ui.text("attempts.operation"), 0.0F, 1.4F},
       &AttemptHeader::scenario_name,
       name_cell,
       by(&AttemptHeader::scenario_name)},
      {{ui.text("attempts.person")},
       [&ui](Attempt attempt) { return person_of(ui, attempt); },
       plain_cell,
       by(&AttemptHeader::login)},
      {{ui.text("attempts.started"), 160.0F},
       [](Ui& own, Attempt attempt, const Rect& cell) {
         draw_moment_cell(own, cell, attempt.started_utc, {Type::Body, own.theme().text_secondary});
       },
       {},
       order},
      {{ui.text("attempts.kind"), 104.0F, 1.0F, Align::Left, kind_from},
       [&ui](Attempt attempt) { return std::string(kind_text(ui, attempt)); }},
      {{ui.text("attempts.state"), 190.0F, 1.0F, Align::Left, state_from}, draw_attempt_state},
      {{ui.text("attempts.score"), 88.0F, 1.0F, Align::Right},
       draw_attempt_score,
       {},
       by(&AttemptHeader::score_milli)},
  };
}

}  // namespace

void AttemptsScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  attempts_.read(ui, shell, ui.text("attempts.reading"), signed_in_,
                 [](database::Session& session) { return session.attempts(shown_most); });
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
               {Icon::History, ui.text("attempts.empty"), ui.text("attempts.empty.sentence")});
  } else {
    draw_table(ui, content);
  }
}

void AttemptsScreen::draw_table(Ui& ui, const Rect& content) {
  const RowTable<AttemptHeader> shown{
      ui.text("attempts.title"),
      [](const AttemptHeader& attempt) { return std::to_string(attempt.order); },
      [&](const AttemptHeader& attempt) {
        return ui.texts().say("attempts.row", {{"operation", attempt.scenario_name},
                                               {"moment", moment_text(attempt.started_utc)}});
      },
      columns_of(ui)};
  std::vector<AttemptHeader>& attempts = attempts_.value();
  const TableResponse response = table(ui, "attempts", content, shown, attempts, table_);
  if (response.opened)
    navigator_.show_result(attempts[static_cast<std::size_t>(*response.opened)].id);
  if (response.has_sort_changed) sort_rows(attempts, shown.columns, table_.sort);
}

}  // namespace hallux::ui
