#include "ui/screens/parts/help_rows.h"

#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/person_cell.h"
#include "ui/screens/parts/value_text.h"
#include "ui/times/local_time.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

namespace {

using database::HelpRequest;

constexpr float row_height = 64.0F, roomy_from = 460.0F;
constexpr float head_height = 44.0F, moment_gap = 20.0F, answer_head = 24.0F;

std::string row_title(const Texts& texts, const HelpRequest& request, bool names_asker) {
  if (!names_asker) return help_moment(texts, request);
  return texts.say("help.of",
                   {{"person", request.asker_name},
                    {"operation", operation_text(request.scenario_name)},
                    {"number", grouped(static_cast<long>(request.attempt_number))},
                    {"moment", clock_text(static_cast<double>(request.moment.moment_us) / 1.0e6)}});
}

void draw_request_cell(Ui& ui, const HelpRequest& request, bool names_asker, const Rect& cell) {
  Rect rest = inset(cell, 0.0F, 8.0F);
  ui.canvas().text_in(take_top(rest, 24.0F), {Type::BodyMedium, ui.theme().text},
                      row_title(ui.texts(), request, names_asker), true);
  ui.canvas().text_in(take_top(rest, 22.0F), {Type::Small, ui.theme().text_secondary},
                      request.question, true);
}

std::string answered_by(const Texts& texts, const database::HelpAnswer& answer) {
  return answer.by_name.empty()
             ? texts.say("help.answered_on", {{"moment", full_moment_text(answer.answered_utc)}})
             : texts.say("help.answered_by", {{"person", answer.by_name},
                                              {"moment", full_moment_text(answer.answered_utc)}});
}

}  // namespace

std::string help_moment(const Texts& texts, const HelpRequest& request) {
  return texts.say("help.moment",
                   {{"operation", operation_text(request.scenario_name)},
                    {"number", grouped(static_cast<long>(request.attempt_number))},
                    {"moment", clock_text(static_cast<double>(request.moment.moment_us) / 1.0e6)}});
}

int help_rows(Ui& ui, const Rect& rect, const HelpRowsSpec& rows,
              std::span<const HelpRequest* const> requests, database::HelpRequestId chosen) {
  using Request = const HelpRequest&;
  RowTable<HelpRequest> shown{
      rows.label,
      [](Request request) { return std::to_string(request.id.number); },
      [&](Request request) { return row_title(ui.texts(), request, rows.names_asker); },
      {{{ui.text("help.question")},
        [&](Ui& own, Request request, const Rect& cell) {
          draw_request_cell(own, request, rows.names_asker, cell);
        }},
       {{ui.text("help.asked"), 150.0F, 1.0F, Align::Left, roomy_from},
        [](Ui& own, Request request, const Rect& cell) {
          draw_moment_cell(own, cell, request.asked_utc, {Type::Small, own.theme().text_secondary});
        }},
       {{ui.text("help.state"), 96.0F}, [](Ui& own, Request request, const Rect& cell) {
          pill(own, {cell.x, cell.mid_y()},
               own.text(request.answer ? "help.answered" : "help.open"),
               request.answer ? Meaning::Good : Meaning::Info);
        }}}};
  shown.row_height = row_height;
  TableState state;
  if (chosen.number > 0) state.chosen = {std::to_string(chosen.number)};
  return table(ui, rows.id, rect, shown, requests, state).opened.value_or(-1);
}

float help_request_height(const Ui& ui, const HelpRequest& request, float width) {
  float height = head_height + 12.0F + ui.paragraph_height(Type::Body, request.question, width) +
                 16.0F + header_button_height + moment_gap;
  if (request.answer)
    height +=
        16.0F + answer_head + ui.paragraph_height(Type::Body, request.answer->text, width) + 8.0F +
        ui.paragraph_height(Type::Small, answered_by(ui.texts(), *request.answer), width) + 12.0F;
  return height;
}

bool draw_help_request(Ui& ui, std::string_view id, Rect& rest, const HelpRequest& request,
                       bool names_asker) {
  const Theme& theme = ui.theme();
  Rect head = take_top(rest, head_height, 12.0F);
  if (names_asker) {
    person_avatar(ui, {take_left(head, 36.0F, 12.0F).x + 18.0F, head.mid_y()}, 18.0F,
                  request.asker_name, request.asker);
  }
  ui.canvas().text_in(take_top(head, 24.0F), {Type::BodyStrong, theme.text},
                      names_asker ? request.asker_name : help_moment(ui.texts(), request), true);
  ui.canvas().text_in(
      take_top(head, 20.0F), {Type::Small, theme.text_secondary},
      names_asker ? help_moment(ui.texts(), request) : full_moment_text(request.asked_utc), true);
  text_line(ui, rest, Type::Body, theme.text, request.question, 16.0F);
  const ButtonSpec moment{ui.text("help.see_moment"), ButtonLook::Secondary, Icon::Play};
  const bool is_asked = button_in_line(ui, std::string(id) + ".moment",
                                       take_top(rest, header_button_height, moment_gap), moment);
  if (request.answer) {
    ui.canvas().hairline_across(rest.x, rest.y, rest.w, theme.line);
    take_top(rest, 16.0F);
    ui.canvas().text_in(take_top(rest, answer_head), {Type::SmallMedium, theme.text},
                        ui.text("help.answer"));
    text_line(ui, rest, Type::Body, theme.text, request.answer->text, 8.0F);
    text_line(ui, rest, Type::Small, theme.text_caption, answered_by(ui.texts(), *request.answer),
              12.0F);
  }
  return is_asked;
}

}  // namespace hallux::ui
