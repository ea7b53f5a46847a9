#include "ui/widgets/controls/card.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float title_baseline = 36.0F, title_height = 52.0F;
constexpr float message_body_top = 41.0F, message_head = 24.0F;
constexpr double quick_s = 0.15;

// The mark is drawn by the caller, 42 above the title.
bool draw_notice(Ui& ui, std::string_view id, const Rect& content, std::string_view title,
                 std::string_view sentence, std::string_view action, Point mark) {
  Canvas& canvas = ui.canvas();
  canvas.text_in({content.x, mark.y + 30.0F, content.w, 24.0F},
                 {Type::BodyStrong, ui.theme().text, Align::Centre}, title);
  const float top = mark.y + 56.0F;
  const float height =
      canvas.paragraph({content.x, top, content.w, content.bottom() - top},
                       {Type::Small, ui.theme().text_secondary, Align::Centre}, sentence);
  if (action.empty()) return false;
  const ButtonSpec spec{action};
  const float width = std::min(std::max(140.0F, button_width(ui, spec)), content.w);
  return button(
      ui, std::string(id) + ".action",
      {content.mid_x() - width / 2.0F, mark.y + 72.0F + height, width, header_button_height}, spec);
}

Point mark_of(const Ui& ui, const Rect& content, std::string_view sentence,
              std::string_view action) {
  const float words = ui.paragraph_height(Type::Small, sentence, std::max(content.w, 1.0F));
  const float height = 72.0F + 16.0F + words + (action.empty() ? 0.0F : header_button_height);
  return {content.mid_x(), content.mid_y() - height / 2.0F + 16.0F};
}

// The width of what stands at the right: a name in it may be long.
float message_side(const Ui& ui, const MessageRow& row, float width) {
  const float needed = std::max(ui.width_of(Type::SmallMedium, row.right),
                                ui.width_of(Type::SmallMedium, row.action));
  return std::min(std::ceil(needed) + 1.0F, 0.5F * width);
}

// The width that head and body have beside the shape and what stands at the right.
float message_room(const Ui& ui, const MessageRow& row, float width) {
  return std::max(1.0F, width - 32.0F - message_side(ui, row, width) - 24.0F);
}

// Of a head that takes more than its one line: by how much the body begins lower.
float message_head_more(const Ui& ui, const MessageRow& row, float room) {
  return std::max(0.0F, ui.paragraph_height(Type::BodyStrong, row.head, room) - message_head);
}

}  // namespace

Rect card(Ui& ui, const Rect& rect, std::string_view title, float padding) {
  draw_card(ui.canvas(), ui.theme(), rect);
  if (title.empty()) return inset(rect, padding);
  ui.canvas().push_room(rect);
  ui.canvas().text_on_baseline({rect.x + padding, rect.y + title_baseline},
                               {Type::CardTitle, ui.theme().text}, title);
  ui.canvas().pop_room();
  return {rect.x + padding, rect.y + title_height, rect.w - 2.0F * padding,
          rect.h - title_height - padding};
}

void page_title(Ui& ui, Point left_top, std::string_view title, std::string_view sentence) {
  ui.canvas().text_on_baseline({left_top.x, left_top.y + 24.0F}, {Type::Title, ui.theme().text},
                               title);
  ui.canvas().text_on_baseline({left_top.x, left_top.y + 50.0F},
                               {Type::Body, ui.theme().text_secondary}, sentence);
}

bool empty_card(Ui& ui, std::string_view id, const Rect& content, const EmptyCard& empty) {
  const Point mark = mark_of(ui, content, empty.sentence, empty.action);
  ui.canvas().icon(mark, empty.icon, IconSize::Empty, ui.theme().text_caption);
  return draw_notice(ui, id, content, empty.title, empty.sentence, empty.action, mark);
}

bool failed_card(Ui& ui, std::string_view id, const Rect& content, const FailedCard& failed) {
  const Point mark = mark_of(ui, content, failed.reason, failed.action);
  draw_meaning(ui.canvas(), ui.theme(), Meaning::Bad, mark, 14.0F);
  return draw_notice(ui, id, content, failed.title, failed.reason, failed.action, mark);
}

float message_row_height(const Ui& ui, const MessageRow& row, float width) {
  const float room = message_room(ui, row, width);
  const float words = ui.paragraph_height(Type::Small, row.body, room);
  return message_body_top + message_head_more(ui, row, room) + std::max(words, 40.0F) + 14.0F;
}

bool message_row(Ui& ui, std::string_view id, const Rect& rect, const MessageRow& row) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const float room = message_room(ui, row, rect.w), middle = rect.y + 27.0F;
  draw_meaning(canvas, theme, row.meaning, {rect.x + 10.0F, middle}, 8.0F);
  const float body_top = message_body_top + message_head_more(ui, row, room);
  canvas.paragraph(
      {rect.x + 32.0F, middle - 0.5F * message_head, room, body_top - 27.0F + 0.5F * message_head},
      {Type::BodyStrong, theme.text}, row.head);
  canvas.paragraph({rect.x + 32.0F, rect.y + body_top, room, rect.h - body_top},
                   {Type::Small, theme.text_secondary}, row.body);
  const float side = message_side(ui, row, rect.w);
  canvas.text_in({rect.right() - side, middle - 0.5F * message_head, side, message_head},
                 {Type::SmallMedium, theme.text, Align::Right}, row.right, true);
  if (row.action.empty()) return false;
  return link(ui, std::string(id) + ".action", {rect.right(), middle + 24.0F}, row.action,
              Align::Right, Type::SmallMedium);
}

void loading_rows(Ui& ui, const Rect& content, int rows, double since_s) {
  const double waited_s = ui.time_s() - since_s;
  if (waited_s < quick_s) {
    ui.want_frame_in_s(quick_s - waited_s + 0.01);
    return;
  }
  constexpr float step = 34.0F;
  for (int row = 0; row < rows; ++row) {
    const float y = content.y + 10.0F + step * static_cast<float>(row);
    if (y + 20.0F > content.bottom()) break;
    const Color bone = ui.theme().raise;
    ui.canvas().fill({content.x, y, 28.0F, 20.0F}, bone, 6.0F);
    ui.canvas().fill({content.x + 40.0F, y + 4.0F,
                      content.w * (0.42F - 0.05F * static_cast<float>(row % 4)), 12.0F},
                     bone, 4.0F);
    ui.canvas().fill({content.right() - content.w * 0.27F, y + 4.0F, content.w * 0.27F, 12.0F},
                     bone, 4.0F);
  }
}

}  // namespace hallux::ui
