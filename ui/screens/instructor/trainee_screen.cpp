// One trainee, as a member of one cohort: standings on top, attempts below. All is read in one turn
// of the session, from the instructor's desk of that cohort, which refuses anybody who is not in
// it. It is read again whenever the screen is entered, since a result may have been decided on the
// screen above it.
#include "ui/screens/instructor/trainee_screen.h"

#include <algorithm>
#include <array>

#include "ui/screens/parts/attempt_marks.h"
#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/standing.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using database::AttemptHeader;
using database::OperationStanding;

constexpr float standing_width = 232.0F, standing_height = 138.0F, roomy_from = 680.0F;

std::string_view competence_id(Competence competence) noexcept {
  constexpr std::array<std::string_view, 5> ids{"cohort.legend.not_started",
                                                "cohort.legend.learning", "cohort.legend.competent",
                                                "cohort.legend.slipped", "cohort.legend.stale"};
  return ids[static_cast<std::size_t>(competence)];
}

/// How many standing cards lie beside each other.
int standings_per_row(float width) noexcept {
  return std::max(1, static_cast<int>((width + space::between_cards) /
                                      (standing_width + space::between_cards)));
}

float standings_height(float width, std::size_t count) noexcept {
  const auto rows =
      (static_cast<int>(count) + standings_per_row(width) - 1) / standings_per_row(width);
  return static_cast<float>(rows) * (standing_height + space::between_cards);
}

std::vector<RowColumn<AttemptHeader>> columns_of(const Ui& ui) {
  using Attempt = const AttemptHeader&;
  return {
      {{ui.text("attempts.number"), 48.0F, 1.0F, Align::Right, roomy_from},
       [](Attempt attempt) { return grouped(static_cast<long>(attempt.number)); },
       caption_cell},
      {{ui.text("attempts.operation")},
       [](Attempt attempt) { return operation_text(attempt.scenario_name); },
       name_cell},
      {{ui.text("attempts.started"), 150.0F},
       [](Ui& own, Attempt attempt, const Rect& cell) {
         draw_moment_cell(own, cell, attempt.started_utc, {Type::Body, own.theme().text_secondary});
       }},
      {{ui.text("attempts.kind"), 104.0F, 1.0F, Align::Left, roomy_from},
       [&ui](Attempt attempt) { return std::string(kind_text(ui, attempt)); }},
      {{ui.text("attempts.state"), 150.0F, 1.0F, Align::Left, roomy_from}, draw_attempt_state},
      {{ui.text("attempts.score"), 84.0F, 1.0F, Align::Right}, draw_attempt_score},
  };
}

}  // namespace

TraineeScreen::File TraineeScreen::read(database::Session& session, database::CohortId cohort,
                                        database::PersonId trainee) {
  database::InstructorDesk desk = instructor_of(session, cohort);
  File file;
  file.cohort_name = desk.cohort().name;
  file.attempts = desk.attempts_of(trainee);  // refuses one who is not of the cohort
  file.progress = progress_in(desk.trainee(trainee));
  file.now_utc = utc_now_text();
  return file;
}

void TraineeScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  file_.read(ui, shell, ui.text("trainee.reading"), signed_in_,
             [cohort = cohort_, trainee = trainee_](database::Session& session) {
               return read(session, cohort, trainee);
             });
  const float width = content.w - 2.0F * page_margin(content);
  const float above =
      file_.is_ready() ? standings_height(width, file_.value().progress.standing.operations.size())
                       : 0.0F;
  const Page scrolled(ui, "trainee", ui.text("trainee.attempts"), content, 420.0F + above);
  Rect page = scrolled.rect();
  if (draw_head(ui, page)) shell.pop();
  if (file_.is_ready()) draw_standings(ui, page);
  const Rect inside = card(ui, page, ui.text("trainee.attempts"));
  if (file_.draw_until_ready(ui, "trainee.failed", inside, 8)) draw_attempts(ui, inside);
}

bool TraineeScreen::draw_head(Ui& ui, Rect& page) {
  std::string name, sentence;
  if (file_.is_ready()) {
    const File& file = file_.value();
    const database::TraineeStanding& standing = file.progress.standing;
    name = person_name_of(ui.texts(), standing.login, standing.display_name);
    sentence = ui.texts().say_count("trainee.sentence", static_cast<long>(file.attempts.size()),
                                    {{"cohort", file.cohort_name}, {"login", standing.login}});
  }
  PageHead head =
      course_head(ui, *signed_in_, name.empty() ? ui.text("role.trainee") : std::string_view(name),
                  sentence.empty() ? ui.text("trainee.reading") : std::string_view(sentence));
  head.has_back = true;
  return page_head(ui, "trainee", page, head).is_back_pressed;
}

void TraineeScreen::draw_standings(Ui& ui, Rect& page) const {
  const std::vector<OperationStanding>& operations = file_.value().progress.standing.operations;
  const int per_row = standings_per_row(page.w);
  Rect row;
  for (std::size_t i = 0; i < operations.size(); ++i) {
    if (static_cast<int>(i) % per_row == 0)
      row = take_top(page, standing_height, space::between_cards);
    draw_standing(ui, take_left(row, std::min(standing_width, row.w), space::between_cards), i);
  }
}

void TraineeScreen::draw_standing(Ui& ui, const Rect& rect, std::size_t operation) const {
  const Theme& theme = ui.theme();
  const TraineeProgress& progress = file_.value().progress;
  const OperationStanding& standing = progress.standing.operations[operation];
  const assessment::LearningState& learning = progress.learning[operation];
  Rect rest = card(ui, rect, {}, space::side_card);
  const Competence competence = competence_of(standing, learning, file_.value().now_utc);
  Rect title = take_top(rest, 22.0F, 6.0F);
  ui.canvas().text_in(title, {Type::BodyStrong, theme.text}, operation_text(standing.scenario_name),
                      true);
  Rect state = take_top(rest, 20.0F, 10.0F);
  draw_competence(ui.canvas(), theme, competence, {state.x + 8.0F, state.mid_y()}, 7.0F,
                  progress_of(standing, learning));
  ui.canvas().text_in({state.x + 24.0F, state.y, state.w - 24.0F, state.h},
                      {Type::Small, theme.text_secondary}, ui.text(competence_id(competence)),
                      true);
  const auto points = [&](const std::optional<std::int64_t>& milli) {
    return milli ? points_text(*milli) : std::string(ui.text("standing.none"));
  };
  const std::string numbers = ui.texts().say(
      "standing.numbers",
      {{"best", points(standing.best_milli)}, {"last", points(standing.last_milli)}});
  ui.canvas().text_in(take_top(rest, 20.0F), {Type::Small, theme.text}, numbers, true);
  ui.canvas().text_in(take_top(rest, 20.0F), {Type::Small, theme.text_caption},
                      ui.texts().say_count("standing.attempts", standing.attempts));
}

void TraineeScreen::draw_attempts(Ui& ui, const Rect& content) {
  const std::vector<AttemptHeader>& attempts = file_.value().attempts;
  if (attempts.empty()) {
    empty_card(ui, "trainee.empty", content,
               {Icon::History, ui.text("attempts.empty"), ui.text("attempts.empty.sentence")});
    return;
  }
  const RowTable<AttemptHeader> shown{
      ui.text("trainee.attempts"),
      [](const AttemptHeader& attempt) { return std::to_string(attempt.order); },
      [&](const AttemptHeader& attempt) { return attempt_name(ui.texts(), attempt); },
      columns_of(ui)};
  const TableResponse response = table(ui, "trainee.row", content, shown, attempts, table_);
  if (response.opened)
    navigator_.show_result(attempts[static_cast<std::size_t>(*response.opened)].id);
}

}  // namespace hallux::ui
