// What lies over a page: menus and questions. A menu takes a press beside it
// with a control as large as the window, so that nothing below hears it. Of a question the safe
// answer has the focus and Esc; the verb has to be meant.
#include "ui/widgets/controls/menu.h"

#include <string>

#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float row = 38.0F, edge = 7.0F, danger_gap = 8.0F, inner = 8.0F;
constexpr float question_width = 480.0F;

std::vector<Rect> rows_of(const Rect& rect, std::span<const MenuItem> items) {
  std::vector<Rect> rows;
  float y = rect.y + edge;
  for (const MenuItem& item : items) {
    if (item.is_dangerous && !rows.empty()) y += danger_gap;
    rows.push_back({rect.x + inner, y, rect.w - 2.0F * inner, row});
    y += row;
  }
  return rows;
}

void draw_row(Ui& ui, const Rect& place, const MenuItem& item, float raised) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  canvas.fill(inset(place, 0.0F, 1.0F), faded(theme.popup_raise, raised), radius::row);
  const Color ink = !item.why_off.empty() ? faded(theme.text_caption, 0.62F)
                    : item.is_dangerous   ? theme.bad_text
                                          : theme.text;
  const bool is_plain = item.why_off.empty() && !item.is_dangerous;
  canvas.icon({place.x + 20.0F, place.mid_y()}, item.icon, IconSize::Control,
              is_plain ? theme.text_secondary : ink);
  const float key_room = item.key.empty() ? 8.0F : key_chip_width(ui, item.key) + 16.0F;
  canvas.text_in({place.x + 42.0F, place.y, place.w - 42.0F - key_room, place.h}, {Type::Body, ink},
                 item.label);
  if (!item.key.empty())
    key_chip(ui, {place.right() - 8.0F - key_chip_width(ui, item.key), place.mid_y()}, item.key);
}

void draw_panel(Ui& ui, const Rect& rect, std::span<const MenuItem> items) {
  draw_popup(ui.canvas(), ui.theme(), rect);
  const std::vector<Rect> rows = rows_of(rect, items);
  for (std::size_t number = 1; number < items.size(); ++number)
    if (items[number].is_dangerous)
      ui.canvas().hairline_across(rect.x + inner, rows[number].y - danger_gap / 2.0F,
                                  rect.w - 2.0F * inner, ui.theme().popup_border);
}

bool pressed_beside(Ui& ui, std::string_view id) {
  Widget beside;
  beside.id = std::string(id) + ".beside";
  beside.label = ui.text("menu.close");
  beside.rect = ui.display();
  beside.is_focusable = false;
  return ui.control(std::move(beside)).is_pressed();
}

Rect inside_display(const Ui& ui, Rect rect) {
  const Rect display = ui.display();
  rect.x = std::clamp(rect.x, 4.0F, std::max(4.0F, display.w - rect.w - 4.0F));
  rect.y = std::clamp(rect.y, 4.0F, std::max(4.0F, display.h - rect.h - 4.0F));
  return rect;
}

}  // namespace

float menu_height(std::span<const MenuItem> items) noexcept {
  float height = 2.0F * edge + row * static_cast<float>(items.size());
  for (std::size_t number = 1; number < items.size(); ++number)
    if (items[number].is_dangerous) height += danger_gap;
  return height;
}

void draw_menu(Ui& ui, const Rect& rect, std::span<const MenuItem> items, int raised) {
  draw_panel(ui, rect, items);
  const std::vector<Rect> rows = rows_of(rect, items);
  for (std::size_t number = 0; number < items.size(); ++number)
    draw_row(ui, rows[number], items[number], static_cast<int>(number) == raised ? 1.0F : 0.0F);
}

int menu(Ui& ui, std::string_view id, Point corner, std::span<const MenuItem> items, float width) {
  const LayerScope layer(ui.canvas(), Layer::Popup);
  const Rect rect = inside_display(ui, {corner.x, corner.y, width, menu_height(items)});
  int answer = pressed_beside(ui, id) ? menu_closed : menu_open;
  draw_panel(ui, rect, items);
  const std::vector<Rect> rows = rows_of(rect, items);
  for (std::size_t number = 0; number < items.size(); ++number) {
    Widget widget{.id = std::string(id) + "." + std::to_string(number),
                  .label = std::string(items[number].label),
                  .rect = rows[number],
                  .role = Role::Option,
                  .is_enabled = items[number].why_off.empty(),
                  .why_off = std::string(items[number].why_off),
                  .group = std::string(id)};
    const std::string name = widget.id;
    const Response response = ui.control(std::move(widget));
    if (number == 0) ui.focus_first(name);
    draw_row(ui, rows[number], items[number],
             response.has_focus || response.shows_ring ? 1.0F : response.hover);
    if (!items[number].why_off.empty()) tell_why_off(ui, name, rows[number], items[number].why_off);
    if (response.is_pressed()) answer = static_cast<int>(number);
  }
  if (ui.shortcut({Key::Escape}, ui.text("menu.close"))) answer = menu_closed;
  if (answer != menu_open) ui.want_frame_in_s(0.0);
  return answer;
}

Answer question(Ui& ui, std::string_view id, const Question& asked) {
  Canvas& canvas = ui.canvas();
  const LayerScope layer(canvas, Layer::Modal);
  const Theme& theme = ui.theme();
  canvas.fill(ui.display(), theme.scrim);
  const float width = std::min(question_width, ui.display().w - 32.0F),
              room = width - 2.0F * space::card;
  const float words = canvas.paragraph_height(Type::Body, asked.consequence, room);
  const Rect rect =
      centred(ui.display(), width, 52.0F + words + 24.0F + button_height + space::card);
  draw_popup(canvas, theme, rect, radius::picture);
  canvas.push_room(rect);
  canvas.text_in({rect.x + space::card, rect.y + 18.0F, room, 26.0F}, {Type::CardTitle, theme.text},
                 asked.title);
  canvas.paragraph({rect.x + space::card, rect.y + 52.0F, room, words},
                   {Type::Body, theme.text_secondary}, asked.consequence);
  const ButtonSpec act{asked.act, asked.is_dangerous ? ButtonLook::Danger : ButtonLook::Secondary};
  const ButtonSpec keep{asked.keep, ButtonLook::Primary};
  Rect line{rect.x + space::card, rect.bottom() - space::card - button_height, room, button_height};
  const std::string act_id = std::string(id) + ".act", keep_id = std::string(id) + ".keep";
  Answer answer = Answer::Waiting;
  if (button(ui, keep_id, take_right(line, button_width(ui, keep), 12.0F), keep))
    answer = Answer::Keep;
  const ButtonSpec other{asked.other, ButtonLook::Secondary};
  if (!other.label.empty() && button(ui, std::string(id) + ".other",
                                     take_right(line, button_width(ui, other), 12.0F), other))
    answer = Answer::Other;
  if (button(ui, act_id, take_right(line, button_width(ui, act)), act)) answer = Answer::Act;
  ui.focus_first(keep_id);
  if (ui.shortcut({Key::Escape}, asked.keep)) answer = Answer::Keep;
  canvas.pop_room();
  if (answer != Answer::Waiting) ui.want_frame_in_s(0.0);
  return answer;
}

}  // namespace hallux::ui
