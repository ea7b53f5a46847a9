#include "ui/widgets/sheet.h"

#include <algorithm>

#include "ui/widgets/button.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float title_height = 60.0F, close_size = 36.0F, margin = 16.0F;

}  // namespace

Sheet::Sheet(Ui& ui, std::string_view id, const SheetSpec& spec)
    : ui_(ui), layer_(ui.canvas(), Layer::Modal) {
  ui.canvas().fill(ui.display(), ui.theme().scrim);
  const Rect inside = draw_panel(id, spec);
  content_ = {inside.x, inside.y, inside.w, spec.content_height};
  is_scrolled_ = spec.content_height > inside.h + 0.5F;
  if (is_scrolled_) {
    // The ring of a control at the edge needs room inside the clip.
    const Rect view = inset(inside, -space::card + 4.0F, 0.0F);
    content_.y -= ui.begin_scroll(std::string(id) + ".scroll", spec.title, view,
                                  spec.content_height + space::side_card);
  }
  if (ui.shortcut({Key::Escape}, ui.text("menu.close"))) wants_close_ = true;
  if (wants_close_) ui.want_frame_in_s(0.0);
}

Sheet::~Sheet() {
  if (is_scrolled_) ui_.end_scroll();
}

Rect Sheet::draw_panel(std::string_view id, const SheetSpec& spec) {
  Canvas& canvas = ui_.canvas();
  const Rect display = ui_.display();
  const float width = std::min(spec.width, display.w - 2.0F * margin);
  const float height =
      std::min(title_height + spec.content_height + space::card, display.h - 2.0F * margin);
  const Rect panel = centred(display, width, height);
  draw_popup(canvas, ui_.theme(), panel, radius::picture);
  const float room = width - 2.0F * space::card - close_size;
  canvas.text_in({panel.x + space::card, panel.y + 18.0F, room, 26.0F},
                 {Type::CardTitle, ui_.theme().text}, spec.title, true);
  IconButtonSpec close;
  close.label = ui_.text("sheet.close");
  close.icon = Icon::Close;
  wants_close_ = icon_button(
      ui_, std::string(id) + ".close",
      {panel.right() - close_size - 14.0F, panel.y + 13.0F, close_size, close_size}, close);
  return {panel.x + space::card, panel.y + title_height, width - 2.0F * space::card,
          height - title_height - (height < display.h - 2.0F * margin ? space::card : 8.0F)};
}

}  // namespace hallux::ui
