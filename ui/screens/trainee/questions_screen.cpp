#include "ui/screens/trainee/questions_screen.h"

#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/help_rows.h"
#include "ui/screens/parts/page.h"

namespace hallux::ui {

namespace {

constexpr float side_width = 440.0F, stacked_height = 380.0F;

}  // namespace

void QuestionsScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  questions_.read(ui, shell, ui.text("questions.reading"), signed_in_,
                  [](database::Session& session) { return trainee_of(session).help_requests(); });
  const bool is_stacked = are_panes_stacked(content.w - 2.0F * page_margin(content));
  const Page scrolled(ui, "questions", ui.text("questions.title"), content,
                      is_stacked ? 440.0F + stacked_height : 480.0F);
  Rect page = scrolled.rect();
  page_head(
      ui, "questions", page,
      course_head(ui, *signed_in_, ui.text("questions.title"), ui.text("questions.sentence")));
  const bool is_empty = questions_.is_ready() && questions_.value().empty();
  const Panes panes = is_empty ? Panes{page, {}} : panes_of(page, side_width, stacked_height);
  const Rect inside = card(ui, panes.main, {});
  const bool can_draw = questions_.draw_until_ready(ui, "questions.failed", inside, 6);
  if (can_draw) draw_list(ui, inside);
  if (is_empty) return;
  const Rect side = card(ui, panes.side, {}, space::side_card);
  if (can_draw) draw_chosen(ui, side);
}

void QuestionsScreen::draw_list(Ui& ui, const Rect& content) {
  const std::vector<database::HelpRequest>& questions = questions_.value();
  if (questions.empty()) {
    empty_card(ui, "questions.empty", content,
               {Icon::Messages, ui.text("questions.empty"), ui.text("questions.empty.sentence")});
    return;
  }
  std::vector<const database::HelpRequest*> shown;
  shown.reserve(questions.size());
  for (const database::HelpRequest& each : questions) shown.push_back(&each);
  if (chosen_.number == 0) chosen_ = shown.front()->id;
  const int opened =
      help_rows(ui, content, {"questions.row", ui.text("questions.title"), false}, shown, chosen_);
  if (opened < 0) return;
  chosen_ = shown[static_cast<std::size_t>(opened)]->id;
  ui.want_frame_in_s(0.0);
}

void QuestionsScreen::draw_chosen(Ui& ui, const Rect& content) {
  const database::HelpRequest* chosen = nullptr;
  for (const database::HelpRequest& each : questions_.value())
    if (each.id == chosen_) chosen = &each;
  if (chosen == nullptr) {
    empty_card(
        ui, "questions.nothing", content,
        {Icon::Messages, ui.text("questions.nothing"), ui.text("questions.nothing.sentence")});
    return;
  }
  const float width = content.w - 12.0F, height = help_request_height(ui, *chosen, width) + 28.0F;
  const float offset = ui.begin_scroll("questions.chosen", ui.text("help.question"),
                                       inset(content, -8.0F, -4.0F), height);
  Rect rest{content.x, content.y - offset, width, height};
  if (draw_help_request(ui, "questions", rest, *chosen, false))
    navigator_.show_replay(chosen->attempt, static_cast<double>(chosen->moment.moment_us) * 1e-6);
  if (!chosen->answer)
    text_line(ui, rest, Type::Small, ui.theme().text_caption, ui.text("questions.waiting"));
  ui.end_scroll();
}

}  // namespace hallux::ui
