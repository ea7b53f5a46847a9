#include "ui/widgets/dialog.h"

#include <string>

#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float dialog_width = 520.0F, edge = 24.0F, title_height = 30.0F, gap = 16.0F;
/// Room around the fields for their focus rings, which a region that scrolls would clip.
constexpr float ring_room = 6.0F;

struct Layout {
  Rect panel, form, buttons;
  float words = 0.0F, error = 0.0F;  ///< heights
};

Layout layout_of(const Ui& ui, const Dialog& shown) {
  const Rect display = ui.display();
  Layout layout;
  const float width = std::min(dialog_width, display.w - 32.0F), room = width - 2.0F * edge;
  layout.words =
      shown.sentence.empty() ? 0.0F : ui.paragraph_height(Type::Body, shown.sentence, room) + gap;
  layout.error = shown.error.empty()
                     ? 0.0F
                     : ui.paragraph_height(Type::Small, shown.error, room - 24.0F) + gap;
  const float fixed =
      2.0F * edge + title_height + gap / 2.0F + layout.words + layout.error + gap + button_height;
  const float form = std::min(shown.form_height, std::max(80.0F, display.h - 24.0F - fixed));
  layout.panel = centred(display, width, fixed + form);
  Rect rest = inset(layout.panel, edge);
  take_top(rest, title_height + gap / 2.0F + layout.words);
  layout.buttons = take_bottom(rest, button_height, gap);
  take_bottom(rest, layout.error);
  layout.form = rest;
  return layout;
}

void draw_words(Ui& ui, const Dialog& shown, const Layout& layout) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const Rect inner = inset(layout.panel, edge);
  canvas.text_in({inner.x, inner.y, inner.w, title_height}, {Type::CardTitle, theme.text},
                 shown.title);
  if (!shown.sentence.empty()) {
    canvas.paragraph({inner.x, inner.y + title_height + gap / 2.0F, inner.w, layout.words - gap},
                     {Type::Body, theme.text_secondary}, shown.sentence);
  }
  if (shown.error.empty()) return;
  const float top = layout.form.bottom() + gap / 2.0F;
  draw_meaning(canvas, theme, Meaning::Bad, {inner.x + 8.0F, top + 10.0F}, 7.0F);
  canvas.paragraph({inner.x + 24.0F, top, inner.w - 24.0F, layout.error},
                   {Type::Small, theme.bad_text}, shown.error);
}

Answer draw_buttons(Ui& ui, std::string_view id, const Dialog& shown, bool is_ready, Rect line) {
  ButtonSpec act{shown.act, shown.is_dangerous ? ButtonLook::Danger : ButtonLook::Primary};
  act.is_enabled = is_ready;
  act.is_busy = shown.is_busy;
  const ButtonSpec keep{shown.keep, ButtonLook::Secondary};
  Answer answer = Answer::Waiting;
  const Rect act_place = take_right(line, button_width(ui, act) + 24.0F, 12.0F);
  if (button(ui, std::string(id) + ".keep", take_right(line, button_width(ui, keep)), keep))
    answer = Answer::Keep;
  if (button(ui, std::string(id) + ".act", act_place, act)) answer = Answer::Act;
  if (ui.shortcut({Key::Escape}, shown.keep)) answer = Answer::Keep;
  return answer;
}

}  // namespace

Answer dialog(Ui& ui, std::string_view id, const Dialog& shown,
              const std::function<bool(const Rect& form)>& draw_form) {
  Canvas& canvas = ui.canvas();
  const LayerScope layer(canvas, Layer::Modal);
  canvas.fill(ui.display(), ui.theme().scrim);
  const Layout layout = layout_of(ui, shown);
  draw_popup(canvas, ui.theme(), layout.panel, radius::picture);
  canvas.push_room(layout.panel);
  draw_words(ui, shown, layout);
  const Rect view = inset(layout.form, -ring_room);
  const float offset = ui.begin_scroll(std::string(id) + ".form", shown.title, view,
                                       shown.form_height + 2.0F * ring_room);
  const bool is_ready =
      draw_form({layout.form.x, layout.form.y - offset, layout.form.w, shown.form_height});
  ui.end_scroll();
  const Answer answer = draw_buttons(ui, id, shown, is_ready, layout.buttons);
  canvas.pop_room();
  if (answer != Answer::Waiting) ui.want_frame_in_s(0.0);
  return answer;
}

}  // namespace hallux::ui
