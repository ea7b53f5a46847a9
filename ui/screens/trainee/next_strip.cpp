#include "ui/screens/trainee/next_strip.h"

#include <algorithm>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/card.h"

namespace hallux::ui {

NextAnswer draw_next_strip(Ui& ui, const Rect& strip, const NextStrip& next) {
  const Theme& theme = ui.theme();
  Rect inside = inset(card(ui, strip, {}, 0.0F), 18.0F, 0.0F);
  const Rect tile = centred(take_left(inside, 36.0F, 16.0F), 36.0F, 36.0F);
  ui.canvas().fill(tile, theme.accent_soft, radius::control);
  ui.canvas().icon(tile.centre(), next.icon, IconSize::Tile, theme.accent);
  const ButtonSpec go{next.go_label, next.is_primary ? ButtonLook::Primary : ButtonLook::Secondary};
  const float go_width = std::max(120.0F, button_width(ui, go));
  const Rect go_place = centred(take_right(inside, go_width, 12.0F), go_width, button_height);
  NextAnswer answer = NextAnswer::Waiting;
  if (!next.aside_id.empty()) {
    const ButtonSpec aside{next.aside_label, ButtonLook::Ghost};
    const float width = button_width(ui, aside);
    const Rect place = centred(take_right(inside, width, 12.0F), width, button_height);
    if (button(ui, next.aside_id, place, aside)) answer = NextAnswer::Aside;
  }
  inside.w -= 12.0F;
  ui.canvas().text_in({inside.x, strip.mid_y() - 23.0F, inside.w, 22.0F},
                      {Type::BodyStrong, theme.text}, next.title, true);
  ui.canvas().text_in({inside.x, strip.mid_y() + 1.0F, inside.w, 20.0F},
                      {Type::Small, theme.text_secondary}, next.sentence, true);
  if (button(ui, next.go_id, go_place, go)) answer = NextAnswer::Go;
  return answer;
}

}  // namespace hallux::ui
