#include "ui/screens/operating/hud/hud_lesson.h"

#include <algorithm>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

namespace {

constexpr float lesson_gap = 8.0F, edge = 12.0F, between_lines = 4.0F, widest = 800.0F;
/// Of the person's name, below the mode: how far it may reach.
constexpr float name_width = 228.0F, name_bottom = 92.0F;
constexpr float button_gap = 10.0F, chip_room = 8.0F;

/// A button with its key beside it.
struct KeyedButton {
  const char* id;
  std::string_view key, label;

  ButtonSpec spec() const { return {label, ButtonLook::Secondary}; }
  float width(const Ui& ui) const {
    return key_chip_width(ui, key) + chip_room + button_width(ui, spec());
  }
  bool draw(Ui& ui, Point left_middle) const {
    key_chip(ui, left_middle, key);
    const float chip = key_chip_width(ui, key) + chip_room;
    return button(ui, id,
                  {left_middle.x + chip, left_middle.y - 0.5F * header_button_height,
                   button_width(ui, spec()), header_button_height},
                  spec());
  }
};

}  // namespace

float draw_hud_lesson(Hud& in, float y) {
  if (!in.hud.lesson) return y;
  const HudLesson& lesson = *in.hud.lesson;
  const KeyedButton skip{"flight.skip", in.ui.text("key.s"), in.ui.text("flight.skip")};
  const KeyedButton again{"flight.again", in.ui.text("key.b"), in.ui.text("flight.again")};
  const float buttons = skip.width(in.ui) + button_gap + again.width(in.ui);
  const float width = std::min(widest, in.room.w);
  const float words = width - 2.0F * hud_pad - buttons - hud_gap;
  const float task = in.ui.paragraph_height(Type::SmallMedium, lesson.task, words);
  const float goal = in.ui.paragraph_height(Type::Small, lesson.goal, words);
  const float height = task + between_lines + goal + 2.0F * edge;
  const float left = in.ui.display().mid_x() - 0.5F * width;
  const bool is_under_name = left < in.room.x + name_width;
  const float above_it = is_under_name ? std::max(y, in.room.y + name_bottom) : y;
  const Rect rect{left, above_it + lesson_gap, width, height};
  const HudPanel panel(in, "flight.panel", rect, radius::picture, HudFading::Never);
  const Rect above{rect.x + hud_pad, rect.y + edge, words, task};
  const Rect below{above.x, above.bottom() + between_lines, words, goal};
  in.canvas().paragraph(above, {Type::SmallMedium, in.theme().text}, lesson.task);
  in.canvas().paragraph(below, {Type::Small, in.theme().text_secondary}, lesson.goal);
  in.ui.tell("flight.task", lesson.task, above);
  in.ui.tell("flight.goal", lesson.goal, below);
  Point at{rect.right() - hud_pad - buttons, rect.mid_y()};
  in.answer.skip = skip.draw(in.ui, at);
  at.x += skip.width(in.ui) + button_gap;
  in.answer.again = again.draw(in.ui, at);
  return rect.bottom();
}

}  // namespace hallux::ui
