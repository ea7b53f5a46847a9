#include "ui/screens/guide/guide_contents.h"

#include <numeric>
#include <string>
#include <vector>

#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr float page_row = 36.0F, heading_row = 30.0F, hit_edge = 9.0F,
                hit_edges = 2.0F * hit_edge + 22.0F, bar_room = 12.0F;
constexpr float text_inset = 12.0F, heading_inset = 26.0F, count_height = 32.0F;

/// A row to choose, with what it is drawn on. True where it was chosen.
bool choose(Ui& ui, const std::string& id, const std::string& label, const Rect& row,
            bool is_chosen) {
  const Response response = ui.control({.id = id,
                                        .label = label,
                                        .rect = row,
                                        .role = Role::Link,
                                        .is_chosen = is_chosen,
                                        .group = "guide.list"});
  const Theme& theme = ui.theme();
  const Color ground = is_chosen ? theme.accent_soft : faded(theme.raise, response.hover);
  ui.canvas().fill(row, ground, radius::row);
  if (response.shows_ring) draw_focus_ring(ui.canvas(), theme, inset(row, 3.0F), radius::row);
  return response.is_pressed();
}

/// A page, or a heading of it.
struct ContentsRow {
  GuidePlace place;
  std::string label;
  bool is_page = false;
};

std::vector<ContentsRow> rows_of(const Guides& guides, std::size_t read) {
  std::vector<ContentsRow> rows;
  for (std::size_t page = 0; page < guides.pages().size(); ++page) {
    const GuidePage& own = guides.pages()[page];
    rows.push_back({{page, 0}, own.title, true});
    if (page != read) continue;
    for (std::size_t block = 1; block < own.blocks.size(); ++block) {
      const MarkdownBlock& heading = own.blocks[block];
      if (heading.kind == MarkdownKind::Heading && heading.level == 2)
        rows.push_back({{page, block}, plain_text(heading.runs), false});
    }
  }
  return rows;
}

}  // namespace

std::optional<GuidePlace> draw_guide_contents(Ui& ui, const Rect& rect, const Guides& guides,
                                              GuidePlace reading) {
  const std::vector<ContentsRow> rows = rows_of(guides, reading.page);
  float height = 0.0F;
  for (const ContentsRow& row : rows) height += row.is_page ? page_row : heading_row;
  std::optional<GuidePlace> chosen;
  const Theme& theme = ui.theme();
  float y =
      rect.y - ui.begin_scroll("guide.contents.list", ui.text("guide.contents"), rect, height);
  for (const ContentsRow& row : rows) {
    const Rect place{rect.x, y, rect.w - bar_room, row.is_page ? page_row : heading_row};
    const std::string id = row.is_page ? "guide.page." + std::to_string(row.place.page)
                                       : "guide.heading." + std::to_string(row.place.block);
    const bool is_read = row.place == reading;
    if (choose(ui, id, row.label, inset(place, 0.0F, 1.0F), is_read)) chosen = row.place;
    const float left = row.is_page ? text_inset : heading_inset;
    const Type type = row.is_page ? Type::BodyMedium : Type::Small;
    const bool is_page_read = row.is_page && row.place.page == reading.page;
    ui.canvas().text_in({place.x + left, place.y, place.w - left - text_inset, place.h},
                        {type, is_read || is_page_read ? theme.text : theme.text_secondary},
                        row.label, true);
    y += place.h;
  }
  ui.end_scroll();
  return chosen;
}

std::optional<GuidePlace> draw_guide_hits(Ui& ui, const Rect& rect, const Guides& guides,
                                          std::span<const GuideHit> hits) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  Rect list = rect;
  canvas.text_in(inset(take_top(list, count_height), text_inset, 0.0F),
                 {Type::SmallMedium, theme.text_caption},
                 ui.texts().say_count("guide.found", static_cast<long>(hits.size())), true);
  std::optional<GuidePlace> chosen;
  const float width = list.w - bar_room - 2.0F * text_inset;
  std::vector<float> heights;
  for (const GuideHit& hit : hits)
    heights.push_back(ui.paragraph_height(Type::Small, hit.words, width) + hit_edges);
  float y = list.y - ui.begin_scroll("guide.hits", ui.text("guide.search"), list,
                                     std::accumulate(heights.begin(), heights.end(), 0.0F));
  for (std::size_t hit = 0; hit < hits.size(); ++hit) {
    const Rect place{list.x, y, list.w - bar_room, heights[hit]};
    y += place.h;
    const std::string& title = guides.pages()[hits[hit].place.page].title;
    if (choose(ui, "guide.hit." + std::to_string(hit), title + ": " + hits[hit].words,
               inset(place, 0.0F, 2.0F), false))
      chosen = hits[hit].place;
    Rect words = inset(place, text_inset, hit_edge);
    canvas.text_in(take_bottom(words, 18.0F), {Type::Caption, theme.text_caption}, title, true);
    canvas.paragraph(words, {Type::Small, theme.text}, hits[hit].words);
  }
  ui.end_scroll();
  return chosen;
}

}  // namespace hallux::ui
