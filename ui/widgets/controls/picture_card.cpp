#include "ui/widgets/controls/picture_card.h"

#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float padding = 16.0F;

void draw_mark(Ui& ui, const Rect& rect, std::string_view mark) {
  const float width = ui.width_of(Type::CaptionMedium, mark) + 40.0F;
  const Rect chip{rect.x + 12.0F, rect.y + 12.0F, width, 24.0F};
  ui.canvas().fill(chip, ui.theme().hud, 12.0F);
  draw_meaning(ui.canvas(), ui.theme(), Meaning::Warn, {chip.x + 15.0F, chip.mid_y()}, 5.5F);
  ui.canvas().text({chip.x + 28.0F, chip.mid_y()}, {Type::CaptionMedium, ui.theme().text}, mark);
}

/// In the place of the picture: why there is none.
void draw_note(Ui& ui, const Rect& picture, const PictureCardSpec& spec) {
  const float room = picture.w - 2.0F * padding;
  const float height = ui.paragraph_height(Type::Small, spec.picture_note, room);
  ui.canvas().paragraph({picture.x + padding, picture.mid_y() - height / 2.0F, room, height},
                        {Type::Small, ui.theme().text_caption, Align::Centre}, spec.picture_note);
}

void draw_state(Ui& ui, const Rect& line, const PictureCardSpec& spec) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  draw_competence(canvas, theme, spec.competence, {line.x + 8.0F, line.mid_y()}, 7.5F,
                  spec.progress);
  Rect rest = line;
  if (!spec.best.empty()) {
    canvas.text_in(take_right(rest, ui.width_of(Type::BodyStrong, spec.best) + 1.0F, 6.0F),
                   {Type::BodyStrong, theme.text, Align::Right}, spec.best);
    canvas.text_in(take_right(rest, ui.width_of(Type::Caption, spec.best_word) + 1.0F, 6.0F),
                   {Type::Caption, theme.text_caption, Align::Right}, spec.best_word);
  }
  const Color ink = spec.competence == Competence::Slipped      ? theme.bad_text
                    : spec.competence == Competence::NotStarted ? theme.text_caption
                                                                : theme.text_secondary;
  canvas.text_in({rest.x + 24.0F, rest.y, rest.w - 24.0F, rest.h}, {Type::Small, ink}, spec.state);
}

}  // namespace

bool picture_card(Ui& ui, std::string_view id, const Rect& place, const PictureCardSpec& spec) {
  const Response response = ui.control({.id = std::string(id),
                                        .label = std::string(spec.name),
                                        .rect = place,
                                        .group = std::string(spec.group)});
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const Rect rect = moved(place, 0.0F, -2.0F * response.hover);
  draw_shadow(canvas, theme, rect, radius::picture,
              response.hover > 0.5F ? Elevation::Popup : Elevation::Card);
  canvas.fill(rect, theme.card, radius::picture);
  const Rect picture{rect.x, rect.y, rect.w, rect.h - (picture_card_height - picture_height)};
  canvas.fill(picture, theme.raise, radius::picture, Corners::Top);
  canvas.picture(spec.picture, picture, radius::picture, Corners::Top);
  if (spec.picture.texture == 0 && !spec.picture_note.empty()) draw_note(ui, picture, spec);
  canvas.hairline_across(rect.x, picture.bottom(), rect.w, theme.line);
  canvas.outline(rect, mixed(theme.line, theme.accent, response.hover), radius::picture,
                 response.hover > 0.5F ? 2.0F : 1.0F);
  if (response.shows_ring) draw_focus_ring(canvas, theme, rect, radius::picture);
  if (!spec.mark.empty()) draw_mark(ui, rect, spec.mark);
  canvas.push_room(rect);
  const float x = rect.x + padding, room = rect.w - 2.0F * padding, y = picture.bottom();
  canvas.text_in({x, y + 14.0F, room, 24.0F}, {Type::CardTitle, theme.text}, spec.name, true);
  canvas.text_in({x, y + 39.0F, room, 20.0F}, {Type::Small, theme.text_secondary}, spec.what, true);
  if (spec.difficulty > 0) {
    meter(ui, {x, y + 77.0F}, spec.difficulty);
    canvas.text({x + 78.0F, y + 77.0F}, {Type::Caption, theme.text_caption}, spec.difficulty_word);
  }
  canvas.hairline_across(x, y + 98.0F, room, theme.line);
  draw_state(ui, {x, y + 109.0F, room, 24.0F}, spec);
  canvas.pop_room();
  return response.is_pressed();
}

}  // namespace hallux::ui
