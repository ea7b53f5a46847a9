#include "ui/widgets/controls/dialog.h"

#include <algorithm>
#include <string>

#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float edge = 24.0F, title_height = 30.0F, gap = 16.0F, error_indent = 24.0F;
constexpr float margin = 16.0F, least_view = 80.0F;
/// Room around the fields for their focus rings, which a region that scrolls would clip.
constexpr float ring_room = 6.0F;

struct Layout {
  Rect panel, view, buttons;
  float words = 0.0F, error = 0.0F, content = 0.0F;  ///< heights; the content is what may scroll
};

Layout layout_of(const Ui& ui, const Dialog& shown) {
  const Rect display = ui.display();
  const float width = std::min(shown.width, display.w - 2.0F * margin), room = width - 2.0F * edge;
  Layout layout;
  if (!shown.sentence.empty())
    layout.words = ui.paragraph_height(Type::Body, shown.sentence, room) + gap;
  if (!shown.error.empty())
    layout.error = ui.paragraph_height(Type::Small, shown.error, room - error_indent) + gap;
  layout.content = layout.words + layout.error + shown.form_height;
  const float fixed = 2.0F * edge + title_height + gap / 2.0F + gap + button_height;
  const float view =
      std::min(layout.content, std::max(least_view, display.h - 2.0F * margin - fixed));
  layout.panel = centred(display, width, fixed + view);
  Rect rest = inset(layout.panel, edge);
  take_top(rest, title_height, gap / 2.0F);
  layout.buttons = take_bottom(rest, button_height, gap);
  layout.view = rest;
  return layout;
}

/// Sentence and error; leaves the place of the form in `rest`.
void draw_text(Ui& ui, const Dialog& shown, const Layout& layout, Rect& rest) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  if (!shown.sentence.empty())
    canvas.paragraph(take_top(rest, layout.words - gap, gap), {Type::Body, theme.text_secondary},
                     shown.sentence);
  if (shown.error.empty()) return;
  const Rect line = take_top(rest, layout.error - gap, gap);
  draw_meaning(canvas, theme, Meaning::Bad, {line.x + 8.0F, line.y + 10.0F}, 7.0F);
  canvas.paragraph({line.x + error_indent, line.y, line.w - error_indent, line.h},
                   {Type::Small, theme.bad_text}, shown.error);
}

Answer draw_buttons(Ui& ui, std::string_view id, const Dialog& shown, std::string_view missing,
                    Rect line) {
  const std::string prefix = std::string(id) + ".";
  ButtonSpec act{shown.act, shown.is_dangerous ? ButtonLook::Danger : ButtonLook::Primary};
  act.why_off = missing;
  act.is_busy = shown.is_busy;
  Answer answer = Answer::Waiting;
  const Rect act_place = take_right(line, button_width(ui, act) + 24.0F, 12.0F);
  const ButtonSpec keep{shown.keep, ButtonLook::Secondary};
  if (!shown.keep.empty() &&
      button(ui, prefix + "keep", take_right(line, button_width(ui, keep)), keep))
    answer = Answer::Keep;
  if (button(ui, prefix + std::string(shown.act_name), act_place, act)) answer = Answer::Act;
  if (ui.shortcut({Key::Escape}, shown.keep.empty() ? shown.act : shown.keep))
    answer = Answer::Keep;
  return answer;
}

}  // namespace

Dialog form_dialog(const Ui& ui, std::string_view title, std::string_view act,
                   const FormState& state, float form_height) {
  Dialog form{title, {}, act, ui.text("form.cancel")};
  form.error = state.fault, form.is_busy = state.is_busy;
  form.form_height = form_height;
  return form;
}

Answer dialog(Ui& ui, std::string_view id, const Dialog& shown,
              const std::function<std::string_view(const Rect& form)>& draw_form) {
  Canvas& canvas = ui.canvas();
  const LayerScope layer(canvas, Layer::Modal);
  canvas.fill(ui.display(), ui.theme().scrim);
  const Layout layout = layout_of(ui, shown);
  draw_popup(canvas, ui.theme(), layout.panel, radius::picture);
  canvas.push_room(layout.panel);
  Rect inner = inset(layout.panel, edge);
  canvas.text_in(take_top(inner, title_height), {Type::CardTitle, ui.theme().text}, shown.title,
                 true);
  const float offset =
      ui.begin_scroll(std::string(id) + ".form", shown.title, inset(layout.view, -ring_room),
                      layout.content + 2.0F * ring_room);
  Rect rest{layout.view.x, layout.view.y - offset, layout.view.w, layout.content};
  draw_text(ui, shown, layout, rest);
  const std::string_view missing = draw_form(rest);
  ui.end_scroll();
  const Answer answer = draw_buttons(ui, id, shown, missing, layout.buttons);
  canvas.pop_room();
  if (answer != Answer::Waiting) ui.want_frame_in_s(0.0);
  return answer;
}

}  // namespace hallux::ui
