#include "ui/screens/parts/page.h"

#include <algorithm>

#include "ui/times/local_time.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

namespace {

constexpr float beside_from = 900.0F, words_least = 380.0F, back_gap = 16.0F;
constexpr float title_line = 36.0F, small_below = 720.0F;

}  // namespace

float page_margin(const Rect& content) noexcept {
  return content.w < small_below ? 20.0F : space::page;
}

Page::Page(Ui& ui, std::string_view id, std::string_view label, const Rect& content,
           float least_height)
    : ui_(ui) {
  const float margin = page_margin(content);
  const float height = std::max(content.h, least_height + 2.0F * margin);
  is_scrolled_ = height > content.h + 0.5F;
  rect_ = inset({content.x, content.y, content.w, height}, margin);
  if (is_scrolled_) rect_.y -= ui.begin_scroll(std::string(id) + ".page", label, content, height);
}

Page::~Page() {
  if (is_scrolled_) ui_.end_scroll();
}

PageHead course_head(const Ui& ui, const SignedInSession& signed_in, std::string_view title,
                     std::string_view sentence) {
  return {title, sentence, signed_in.is_simulated() ? ui.text("course.simulated") : ""};
}

PageHeadResponse page_head(Ui& ui, std::string_view id, Rect& page, const PageHead& head) {
  PageHeadResponse response;
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const bool is_beside = page.w - head.buttons_width >= words_least;
  Rect words = page;
  if (is_beside && head.buttons_width > 0.0F) {
    response.buttons = take_right(words, head.buttons_width, 24.0F);
    response.buttons.y += 4.0F;
    response.buttons.h = header_button_height;
  }
  Rect title = take_top(words, title_line, 4.0F);
  if (head.has_back) {
    // The arrow itself stands at the margin, its button reaches beyond.
    const Rect arrow = take_left(title, 16.0F, back_gap);
    const Rect place{arrow.x - 10.0F, arrow.y, 36.0F, 36.0F};
    response.is_back_pressed =
        icon_button(ui, std::string(id) + ".back", place, {ui.text("shortcut.back"), Icon::Left});
  }
  const float mark = head.mark.empty() ? 0.0F : pill_width(ui, head.mark, true) + 14.0F;
  const float drawn = canvas.text_in({title.x, title.y, title.w - mark, title.h},
                                     {Type::Title, theme.text}, head.title, true);
  if (mark > 0.0F) pill(ui, {title.x + drawn + 14.0F, title.mid_y()}, head.mark, Meaning::Info);
  text_line(ui, words, Type::Body, theme.text_secondary, head.sentence, 20.0F);
  if (!is_beside) {
    response.buttons = take_top(words, header_button_height, 20.0F);
    response.buttons.w = std::min(head.buttons_width, words.w);
  }
  const float bottom = page.bottom();
  page.y = words.y;
  page.h = bottom - words.y;
  return response;
}

bool are_panes_stacked(float page_width) noexcept { return page_width < beside_from; }

Panes panes_of(const Rect& page, float side_width, float stacked_side_height) {
  Rect rest = page;
  Panes panes;
  panes.side = are_panes_stacked(page.w)
                   ? take_bottom(rest, stacked_side_height, space::between_cards)
                   : take_right(rest, side_width, space::between_cards);
  panes.main = rest;
  return panes;
}

ListPage::ListPage(Ui& ui, std::string_view id, const PageHead& head, const Rect& content,
                   const ListPageSpec& spec)
    : page_(ui, id, head.title, content,
            are_panes_stacked(content.w - 2.0F * page_margin(content))
                ? spec.list_height + spec.side_height
                : spec.least_height) {
  Rect rest = page_.rect();
  buttons_ = page_head(ui, id, rest, head).buttons;
  const Panes panes =
      panes_of(rest, std::min(spec.side_width, rest.w * spec.side_share), spec.side_height);
  list_ = spec.has_head ? list_card(ui, panes.main) : card(ui, panes.main, {});
  side_ = panes.side;
}

Rect list_card(Ui& ui, const Rect& rect) {
  const Rect inside = card(ui, rect, {});
  constexpr float top = 8.0F;
  return {inside.x, rect.y + top, inside.w, inside.bottom() - rect.y - top};
}

void fact_line(Ui& ui, Rect& rest, std::string_view name, std::string_view value,
               float name_width) {
  Rect line = take_top(rest, 28.0F);
  ui.canvas().text_in(take_left(line, name_width, 8.0F), {Type::Small, ui.theme().text_caption},
                      name);
  ui.canvas().text_in(line, {Type::Small, ui.theme().text}, value, true);
}

void fact_moment(Ui& ui, Rect& rest, std::string_view name, std::string_view utc) {
  constexpr float name_width = 96.0F;
  Rect line = take_top(rest, 28.0F);
  ui.canvas().text_in(take_left(line, name_width, 8.0F), {Type::Small, ui.theme().text_caption},
                      name);
  draw_moment_cell(ui, line, utc, {Type::Small, ui.theme().text});
}

void draw_moment_cell(Ui& ui, const Rect& cell, std::string_view utc, const TextStyle& style) {
  ui.canvas().text_in(cell, style, moment_text(utc), true, full_moment_text(utc));
}

void text_line(Ui& ui, Rect& rest, Type type, Color color, std::string_view words, float gap) {
  const float height = ui.paragraph_height(type, words, rest.w);
  ui.canvas().paragraph({rest.x, rest.y, rest.w, height}, {type, color}, words);
  take_top(rest, height, gap);
}

}  // namespace hallux::ui
