#include "ui/screens/operating/flight/flight_cards.h"

#include <algorithm>
#include <array>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr float widest = 560.0F, row_height = 26.0F, title_room = 40.0F, gap = 14.0F;

/// Ids of texts, in the order of Lesson.
constexpr std::array<std::string_view, lesson_count> titles{
    "flight.look",     "flight.approach", "flight.start",   "flight.stroke",
    "flight.withdraw", "flight.second",   "flight.take_out"};

void draw_lesson(Ui& ui, const Rect& row, Lesson lesson, LessonEnd end) {
  const bool is_done = end == LessonEnd::Done;
  const Point sign{row.x + 8.0F, row.mid_y()};
  if (is_done) {
    draw_meaning(ui.canvas(), ui.theme(), Meaning::Good, sign, 7.0F);
  } else {
    ui.canvas().ring(sign, 7.0F, ui.theme().text_caption);
  }
  const std::string_view title = ui.text(title_of(lesson));
  ui.canvas().text_in({row.x + 28.0F, row.y, row.w - 28.0F, row.h},
                      {Type::Body, is_done ? ui.theme().text : ui.theme().text_secondary}, title,
                      true);
  if (is_done) return;
  ui.canvas().text_in(row, {Type::Small, ui.theme().text_caption, Align::Right},
                      ui.text("flight.skipped"));
}

}  // namespace

std::string_view title_of(Lesson lesson) noexcept {
  return titles[static_cast<std::size_t>(lesson)];
}

FlightAnswer draw_flown_card(Ui& ui, const FlightLessons& lessons) {
  const float width = std::min(widest, ui.display().w - 32.0F);
  const std::string_view words = ui.text("flight.over.sentence");
  const float words_height = ui.paragraph_height(Type::Small, words, width - 2.0F * space::card);
  const float rows = row_height * static_cast<float>(lesson_count);
  const float height =
      space::card + title_room + rows + gap + words_height + gap + button_height + space::card;
  Rect inside = card(ui, centred(ui.display(), width, height), ui.text("flight.over"));
  for (std::size_t number = 0; number < lesson_count; ++number) {
    const auto lesson = static_cast<Lesson>(number);
    draw_lesson(ui, take_top(inside, row_height), lesson, lessons.end_of(lesson));
  }
  take_top(inside, gap);
  ui.canvas().paragraph(take_top(inside, words_height, gap),
                        {Type::Small, ui.theme().text_secondary}, words);
  const ButtonSpec on{ui.text("flight.operations"), ButtonLook::Primary};
  const ButtonSpec again{ui.text("flight.fly_again"), ButtonLook::Ghost};
  Rect foot = take_bottom(inside, button_height);
  const bool is_on =
      button(ui, "flight.operations", take_right(foot, button_width(ui, on), 12.0F), on);
  const bool is_again =
      button(ui, "flight.fly_again", take_right(foot, button_width(ui, again)), again);
  return is_on ? FlightAnswer::Operations : is_again ? FlightAnswer::Again : FlightAnswer::Waiting;
}

}  // namespace hallux::ui
