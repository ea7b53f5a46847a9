// A toast is a control itself: nothing below it hears a press, and accessibility tools find its
// words. Where it is narrow, title, detail and action stand under each other.
#include "ui/widgets/controls/toast.h"

#include <algorithm>
#include <string>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float shape_room = 44.0F, close_room = 48.0F, close_size = 32.0F;
constexpr float narrow_shape = 34.0F, narrow_close = 36.0F, edge = 14.0F, action_height = 28.0F;
constexpr float progress_height = 48.0F, progress_edge = 20.0F, narrow_edge = 14.0F;

/// Where title, detail and action stand in a toast, and how high it is with them.
struct ToastLayout {
  Rect title, detail;
  Point shape, close, action;
  Align action_align = Align::Right;
  float height = toast_height;
};

ToastLayout wide_layout(const Ui& ui, const Toast& shown, float width) {
  const float action =
      shown.action.empty() ? 0.0F : ui.width_of(Type::BodyMedium, shown.action) + 16.0F;
  const float room = std::max(1.0F, width - shape_room - close_room - action);
  const float title = ui.paragraph_height(Type::BodyMedium, shown.title, room);
  const float detail =
      shown.detail.empty() ? 0.0F : ui.paragraph_height(Type::Small, shown.detail, room);
  ToastLayout layout;
  layout.height = std::max(toast_height, title + detail + 20.0F);
  const float middle = layout.height / 2.0F, top = middle - (title + detail) / 2.0F;
  layout.title = {shape_room, top, room, title};
  layout.detail = {shape_room, top + title, room, detail};
  layout.shape = {24.0F, middle};
  layout.close = {width - 20.0F, middle};
  layout.action = {width - shape_room, middle};
  return layout;
}

ToastLayout narrow_layout(const Ui& ui, const Toast& shown, float width) {
  const float title_room = std::max(1.0F, width - narrow_shape - narrow_close);
  const float room = std::max(1.0F, width - 2.0F * edge);
  const float title = ui.paragraph_height(Type::BodyMedium, shown.title, title_room);
  const float detail =
      shown.detail.empty() ? 0.0F : ui.paragraph_height(Type::Small, shown.detail, room) + 4.0F;
  const float action = shown.action.empty() ? 0.0F : action_height;
  ToastLayout layout;
  layout.height = std::max(toast_height, 2.0F * edge + title + detail + action);
  layout.title = {narrow_shape, edge, title_room, title};
  layout.detail = {edge, edge + title + 4.0F, room, detail};
  layout.shape = {edge + 8.0F, edge + line_height(Type::BodyMedium) / 2.0F};
  layout.close = {width - 20.0F, layout.shape.y};
  layout.action = {edge, layout.height - edge - action / 2.0F + 4.0F};
  layout.action_align = Align::Left;
  return layout;
}

ToastLayout layout_of(const Ui& ui, const Toast& shown, float width) {
  return width < narrow_toast_below ? narrow_layout(ui, shown, width)
                                    : wide_layout(ui, shown, width);
}

std::string words_of(const Toast& shown) {
  std::string words(shown.title);
  if (!shown.detail.empty()) words.append(". ").append(shown.detail);
  return words;
}

Point in(const Rect& rect, Point place) { return {rect.x + place.x, rect.y + place.y}; }

}  // namespace

float toast_height_for(const Ui& ui, const Toast& shown, float width) {
  return layout_of(ui, shown, width).height;
}

ToastAnswer toast(Ui& ui, std::string_view id, const Rect& rect, const Toast& shown) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const ToastLayout layout = layout_of(ui, shown, rect.w);
  ui.area(id, words_of(shown), rect, false);
  draw_popup(canvas, theme, rect);
  draw_meaning(canvas, theme, shown.meaning, in(rect, layout.shape), 8.0F);
  canvas.paragraph(moved(layout.title, rect.x, rect.y), {Type::BodyMedium, theme.text},
                   shown.title);
  if (!shown.detail.empty())
    canvas.paragraph(moved(layout.detail, rect.x, rect.y), {Type::Small, theme.text_secondary},
                     shown.detail);
  ToastAnswer answer = ToastAnswer::Waiting;
  if (!shown.action.empty() && link(ui, std::string(id) + ".action", in(rect, layout.action),
                                    shown.action, layout.action_align, Type::BodyMedium))
    answer = ToastAnswer::Action;
  const Point close = in(rect, layout.close);
  if (icon_button(
          ui, std::string(id) + ".close",
          {close.x - close_size / 2.0F, close.y - close_size / 2.0F, close_size, close_size},
          {ui.text("toast.close"), Icon::Close}))
    answer = ToastAnswer::Closed;
  return answer;
}

float progress_height_for(const Ui& ui, const RunningWork& shown, float width) {
  if (width >= narrow_toast_below) return progress_height;
  return 2.0F * narrow_edge +
         ui.paragraph_height(Type::Small, shown.label, width - 2.0F * narrow_edge) + 38.0F;
}

bool progress(Ui& ui, std::string_view id, const Rect& rect, const RunningWork& shown) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  ui.area(id, shown.label, rect, false);
  draw_shadow(canvas, theme, rect, radius::control, Elevation::Card);
  canvas.fill(rect, theme.card, radius::control);
  canvas.outline(rect, theme.line, radius::control);
  const std::string_view cancel = ui.text("progress.cancel");
  const float cancel_width = ui.width_of(Type::SmallMedium, cancel);
  const TextStyle label{Type::Small, theme.text}, left{Type::Small, theme.text_caption};
  if (rect.w < narrow_toast_below) {
    Rect rest = inset(rect, narrow_edge, narrow_edge);
    const float words = ui.paragraph_height(Type::Small, shown.label, rest.w);
    canvas.paragraph(take_top(rest, words, 4.0F), label, shown.label);
    bar(ui, take_top(rest, 6.0F, 4.0F), shown.share);
    const float y = rest.mid_y() + 2.0F;
    canvas.text_in({rest.x, y - 10.0F, rest.w - cancel_width - 8.0F, 20.0F}, left, shown.time_left,
                   true);
    return link(ui, std::string(id) + ".cancel", {rest.right(), y}, cancel, Align::Right,
                Type::SmallMedium);
  }
  const float y = rect.mid_y() - 8.0F;
  const float time_width =
      shown.time_left.empty() ? 0.0F : ui.width_of(Type::Small, shown.time_left) + 16.0F;
  canvas.text_in(
      {rect.x + progress_edge, y - 10.0F, rect.w - 56.0F - cancel_width - time_width, 20.0F}, label,
      shown.label, true);
  canvas.text({rect.right() - 36.0F - cancel_width, y}, {left.type, left.color, Align::Right},
              shown.time_left);
  bar(ui, {rect.x + progress_edge, rect.mid_y() + 8.0F, rect.w - 2.0F * progress_edge, 6.0F},
      shown.share);
  return link(ui, std::string(id) + ".cancel", {rect.right() - progress_edge, y}, cancel,
              Align::Right, Type::SmallMedium);
}

}  // namespace hallux::ui
