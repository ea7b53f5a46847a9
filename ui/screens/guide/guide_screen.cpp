// The page flows anew where its width or the scale changed; a frame then draws what of it is in
// sight.
//
//     +------------------------------------------------+
//     | <- Guide   (back)                    [ search ]|
//     | contents     | page, at most as wide as one    |
//     |  or what was | reads well                      |
//     |  found       |                                 |
//     +------------------------------------------------+
//
// In a narrow window a button of the head shows the contents in place of the page.
#include "ui/screens/guide/guide_screen.h"

#include <algorithm>
#include <cmath>

#include "ui/screens/guide/guide_contents.h"
#include "ui/screens/parts/page.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/scroll_keys.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr float head_height = 44.0F, below_head = 16.0F, list_width = 272.0F, list_gap = 40.0F;
constexpr float reading_width = 760.0F, beside_from = 900.0F, search_width = 280.0F;
constexpr float bar_room = 24.0F, edge = 6.0F, above_heading = 8.0F, foot = 48.0F;
constexpr float read_above = 80.0F, to_be_noted_never = 1e9F;
constexpr const char* page_region = "guide.text";
constexpr const char* search_id = "guide.search";

Rect placed(const Rect& rect, Point at) { return moved(rect, at.x, at.y); }

bool is_seen(const Rect& rect, const Rect& view) {
  return rect.bottom() >= view.y && rect.y <= view.bottom();
}

PixelSize pixels_of(const Ui& ui, const Rect& rect) {
  const auto whole = [&](float side) {
    return std::max(1, static_cast<int>(std::lround(side * ui.scale())));
  };
  return {whole(rect.w), whole(rect.h)};
}

}  // namespace

GuideScreen::GuideScreen(GuideSection section) : section_(section) {
  reading_.place = guides_.place_of(section);
}

void GuideScreen::go_to(GuidePlace place) {
  reading_.earlier.push_back(reading_.place);
  come_to(place);
}

void GuideScreen::go_back() {
  const GuidePlace before = reading_.earlier.back();
  reading_.earlier.pop_back();
  come_to(before);
}

void GuideScreen::come_to(GuidePlace place) {
  reading_.place = place;
  reading_.is_to_come = true;
  reading_.lit.reset();
  is_list_shown_ = false;
}

// What lies over the page goes first.
void GuideScreen::close_uppermost(Shell& shell) {
  if (!search_.words.empty())
    search_ = {};
  else if (is_list_shown_)
    is_list_shown_ = false;
  else
    shell.close_guide();
}

void GuideScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  const float margin = page_margin(content);
  Rect rest = inset(content, margin, margin / 2.0F);
  const bool is_beside = rest.w >= beside_from;
  const float most = list_width + list_gap + reading_width + bar_room;
  if (is_beside && rest.w > most) rest = centred(rest, most, rest.h);
  draw_head(ui, take_top(rest, head_height, below_head), !is_beside, shell);
  if (is_beside) {
    draw_list(ui, take_left(rest, list_width, list_gap), true);
  } else if (is_list_shown_ || !search_.words.empty()) {
    draw_list(ui, rest, false);
    return hear_keys(ui, {}, shell);
  }
  hear_keys(ui, rest, shell);
  draw_page(ui, rest, shell);
}

void GuideScreen::draw_head(Ui& ui, Rect head, bool has_list_button, Shell& shell) {
  if (icon_button(ui, "guide.close", centred(take_left(head, 36.0F, 8.0F), 36.0F, 36.0F),
                  {ui.text("guide.close"), Icon::Left}))
    shell.close_guide();
  const Rect field_place = take_right(head, std::min(search_width, head.w * 0.55F), 12.0F);
  if (has_list_button &&
      icon_button(ui, "guide.contents", centred(take_right(head, 36.0F, 4.0F), 36.0F, 36.0F),
                  {ui.text("guide.contents"), Icon::Audit, is_list_shown_}))
    is_list_shown_ = !is_list_shown_;
  if (!reading_.earlier.empty() &&
      icon_button(ui, "guide.earlier", centred(take_right(head, 36.0F, 8.0F), 36.0F, 36.0F),
                  {ui.text("guide.earlier"), Icon::Back}))
    go_back();
  ui.canvas().text_in(head, {Type::Section, ui.theme().text}, ui.text("guide.title"), true);
  if (search_field(ui, search_id, centred(field_place, field_place.w, field_height), search_.words,
                   ui.text("guide.search")))
    search_.hits = guides_.found(search_.words, reading_.place.page);
}

void GuideScreen::draw_list(Ui& ui, const Rect& rect, bool is_beside) {
  if (search_.words.empty()) {
    const GuidePlace in_sight{reading_.place.page, heading_above(reading_.place.block)};
    if (const auto chosen = draw_guide_contents(ui, rect, guides_, in_sight)) go_to(*chosen);
    return;
  }
  const std::optional<GuidePlace> chosen = draw_guide_hits(ui, rect, guides_, search_.hits);
  if (chosen) show_found(ui, *chosen, is_beside);
}

void GuideScreen::show_found(Ui& ui, GuidePlace place, bool is_beside) {
  go_to(place);
  reading_.lit = place;
  // Beside the page what was found stays; in its place it would hide it.
  if (!is_beside) search_ = {};
  ui.want_frame_in_s(0.0);
}

void GuideScreen::hear_keys(Ui& ui, const Rect& view, Shell& shell) {
  if (ui.shortcut(with_control(Key::F), ui.text(search_id))) ui.focus(search_id);
  if (!reading_.earlier.empty() &&
      ui.shortcut({Key::Left, {.alt = true}}, ui.text("guide.earlier")))
    go_back();
  if (ui.shortcut({Key::Escape}, ui.text("guide.close"))) close_uppermost(shell);
  const bool is_found = ui.focused() == search_id && !search_.hits.empty();
  if (is_found && ui.shortcut({Key::Enter}, ui.text("guide.first_found")))
    show_found(ui, search_.hits.front().place, !view.is_empty());
  if (!view.is_empty()) scroll_by_keys(ui, page_region, view.h);
}

void GuideScreen::flow(const Ui& ui, float width) {
  const FlowedFor wanted{reading_.place.page, width, ui.scale()};
  if (flowed_for_ == wanted) return;
  flowed_ =
      flow_page(ui, page().blocks, width, &GuidePictures::size_of, [&](std::string_view target) {
        return guides_.followed(reading_.place.page, target).has_value();
      });
  flowed_for_ = wanted;
  pictures_.forget();
  // The same words in another place.
  reading_.is_to_come = true;
}

void GuideScreen::draw_page(Ui& ui, const Rect& view, Shell& shell) {
  const float width = std::min(view.w - bar_room, reading_width);
  flow(ui, width);
  if (reading_.is_to_come) {
    const float top = flowed_.blocks.empty() ? 0.0F : flowed_.blocks[reading_.place.block].y;
    ui.scroll_to(page_region, std::max(0.0F, top - above_heading));
    reading_.is_to_come = false;
    reading_.came_at = -1.0F;
  }
  const Rect region{view.x - edge, view.y, view.w + edge, view.h};
  const float scrolled =
      ui.begin_scroll(page_region, page().title, region, flowed_.height + 2.0F * edge + foot);
  draw_blocks(ui, {view.x, view.y + edge - scrolled}, region, shell);
  ui.end_scroll();
  note_place(scrolled, scrolled + region.h >= flowed_.height + 2.0F * edge + foot - 1.0F);
}

void GuideScreen::draw_blocks(Ui& ui, Point at, const Rect& view, Shell& shell) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  if (reading_.lit && reading_.lit->page == reading_.place.page)
    canvas.fill(inset(placed(flowed_.blocks[reading_.lit->block], at), -edge), theme.accent_soft,
                radius::row);
  for (const FlowSurface& surface : flowed_.surfaces) {
    const Rect rect = placed(surface.rect, at);
    if (!is_seen(rect, view)) continue;
    if (surface.shape == FlowShape::Line)
      canvas.hairline_across(rect.x, rect.y, rect.w, theme.line);
    else
      canvas.fill(rect, theme.raise, radius::row);
  }
  for (const FlowPicture& picture : flowed_.pictures) {
    const Rect rect = placed(picture.rect, at);
    if (!is_seen(rect, view)) continue;
    canvas.fill(rect, theme.raise, radius::picture);
    canvas.picture({pictures_.texture(shell, picture.source, pixels_of(ui, rect)), false}, rect,
                   radius::picture);
    canvas.outline(rect, theme.line, radius::picture);
  }
  draw_words(ui, at, view);
  draw_links(ui, at);
}

void GuideScreen::draw_words(Ui& ui, Point at, const Rect& view) const {
  const Theme& theme = ui.theme();
  for (const FlowWords& words : flowed_.words) {
    const Rect rect = placed(words.rect, at);
    if (!is_seen(rect, view)) continue;
    const bool is_code = words.tone == FlowTone::Code;
    if (is_code) ui.canvas().fill(inset(rect, 0.0F, 1.0F), theme.chip, radius::step);
    const Color color = words.tone == FlowTone::Caption ? theme.text_caption
                        : words.tone == FlowTone::Link  ? theme.accent
                                                        : theme.text;
    ui.canvas().text({rect.x + (is_code ? code_ground_edge : 0.0F), rect.mid_y()},
                     {words.type, color}, words.text);
    if (words.tone == FlowTone::Link)
      ui.canvas().hairline_across(rect.x, rect.mid_y() + 9.0F, rect.w, faded(theme.accent, 0.5F));
  }
}

// A link that goes on in the next line is one for the keyboard, and pressed on each line.
void GuideScreen::draw_links(Ui& ui, Point at) {
  std::optional<GuidePlace> followed;
  for (std::size_t link = 0; link < flowed_.links.size(); ++link) {
    const FlowLink& own = flowed_.links[link];
    bool is_pressed = false, shows_ring = false;
    for (std::size_t line = 0; line < own.rects.size(); ++line) {
      const std::string id = "guide.link." + std::to_string(link);
      const Response response = ui.control({.id = line == 0 ? id : id + "." + std::to_string(line),
                                            .label = own.label,
                                            .rect = placed(own.rects[line], at),
                                            .role = Role::Link,
                                            .is_focusable = line == 0});
      is_pressed |= response.is_pressed();
      shows_ring |= response.shows_ring;
      if (shows_ring)
        draw_focus_ring(ui.canvas(), ui.theme(), placed(own.rects[line], at), radius::step);
    }
    if (is_pressed) followed = guides_.followed(reading_.place.page, own.target);
  }
  if (!followed) return;
  go_to(*followed);
  ui.want_frame_in_s(0.0);
}

// Where somebody read on by themselves, the place is where they are; where a heading was chosen
// that the page's end leaves below its top, it stays the one that was chosen. At the end the last
// heading is read, however low it stands.
void GuideScreen::note_place(float scrolled, bool is_at_end) {
  constexpr float same = 1.0F;
  if (reading_.is_to_come) return;
  if (reading_.came_at < 0.0F) reading_.came_at = scrolled;
  if (std::abs(scrolled - reading_.came_at) < same) return;
  reading_.came_at = to_be_noted_never;
  const auto below = std::ranges::find_if(flowed_.blocks, [&](const Rect& block) {
    return !is_at_end && block.y > scrolled + read_above;
  });
  const auto count = static_cast<std::size_t>(below - flowed_.blocks.begin());
  reading_.place.block = heading_above(count > 0 ? count - 1 : 0);
}

std::size_t GuideScreen::heading_above(std::size_t block) const {
  const auto is_heading = [&](std::size_t at) {
    const MarkdownBlock& own = page().blocks[at];
    return own.kind == MarkdownKind::Heading && own.level <= 2;
  };
  while (block > 0 && !is_heading(block)) --block;
  return block;
}

}  // namespace hallux::ui
