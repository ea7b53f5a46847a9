#include "ui/widgets/controls/tooltip.h"

#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr double resting_s = 0.5;
constexpr float longest_line = 400.0F;
constexpr float padding = 12.0F, distance = 14.0F;

/// Under the control, or above it at the lower edge.
void draw_under(Ui& ui, const Rect& rect, std::string_view label) {
  Canvas& canvas = ui.canvas();
  const LayerScope layer(canvas, Layer::Tooltip);
  const Rect display = ui.display();
  const float width = canvas.width_of(Type::Caption, label) + 2.0F * padding;
  if (width > longest_line) return draw_told_words(canvas, ui.theme(), rect, label);
  Rect popup{rect.mid_x() - width / 2.0F, rect.bottom() + 6.0F, width, 30.0F};
  popup.x = std::clamp(popup.x, 4.0F, std::max(4.0F, display.right() - width - 4.0F));
  if (popup.bottom() > display.bottom() - 4.0F) popup.y = rect.y - 36.0F;
  draw_popup(canvas, ui.theme(), popup, radius::control);
  canvas.text_in(inset(popup, padding, 0.0F), {Type::Caption, ui.theme().text}, label, true);
}

}  // namespace

void tooltip(Ui& ui, Point point, std::string_view value, std::string_view context) {
  Canvas& canvas = ui.canvas();
  const LayerScope layer(canvas, Layer::Tooltip);
  const Rect display = ui.display();
  const float width = std::min(display.w - 8.0F,
                               2.0F * padding + std::max(canvas.width_of(Type::BodyStrong, value),
                                                         canvas.width_of(Type::Caption, context)));
  const float height = context.empty() ? 38.0F : 60.0F;
  Rect rect{point.x + distance, point.y - distance - height, width, height};
  if (rect.right() > display.right() - 4.0F) rect.x = point.x - distance - width;
  rect.x = std::max(rect.x, 4.0F);
  if (rect.y < 4.0F) rect.y = point.y + distance;
  draw_popup(canvas, ui.theme(), rect, radius::control);
  canvas.text_in(
      {rect.x + padding, rect.y + (context.empty() ? 9.0F : 10.0F), rect.w - 2.0F * padding, 20.0F},
      {Type::BodyStrong, ui.theme().text}, value, true);
  if (!context.empty())
    canvas.text_in({rect.x + padding, rect.y + 32.0F, rect.w - 2.0F * padding, 20.0F},
                   {Type::Caption, ui.theme().text_secondary}, context, true);
}

void tooltip_when_resting(Ui& ui, std::string_view id, const Rect& rect, std::string_view label) {
  const double rested_s = ui.hovered_for_s(id);
  if (rested_s <= 0.0) return;
  if (rested_s < resting_s) {
    ui.want_frame_in_s(resting_s - rested_s + 0.01);
    return;
  }
  draw_under(ui, rect, label);
}

void tell_why_off(Ui& ui, std::string_view id, const Rect& rect, std::string_view why) {
  if (ui.is_steered_by_keys() && ui.focused() == id) return draw_under(ui, rect, why);
  tooltip_when_resting(ui, id, rect, why);
}

}  // namespace hallux::ui
