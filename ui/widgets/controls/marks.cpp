#include "ui/widgets/controls/marks.h"

#include <cmath>
#include <numbers>

#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float pill_height = 22.0F, pill_padding = 8.0F, shape_room = 17.0F;
constexpr float key_padding = 6.0F, key_height = 20.0F;
constexpr float ring_stroke = 14.0F, ring_fill_s = 0.5F;

}  // namespace

float pill_width(const Ui& ui, std::string_view label, bool has_shape) {
  return std::ceil(ui.width_of(Type::CaptionMedium, label)) + 2.0F * pill_padding +
         (has_shape ? shape_room : 0.0F);
}

float pill(Ui& ui, Point left_middle, std::string_view label, Meaning meaning, bool has_shape) {
  Canvas& canvas = ui.canvas();
  const float width = pill_width(ui, label, has_shape);
  const Rect rect{left_middle.x, left_middle.y - pill_height / 2.0F, width, pill_height};
  canvas.fill(rect, tint_of(ui.theme(), meaning), pill_height / 2.0F);
  if (has_shape) draw_meaning(canvas, ui.theme(), meaning, {rect.x + 13.0F, left_middle.y}, 5.5F);
  canvas.text({rect.x + pill_padding + (has_shape ? shape_room : 0.0F), left_middle.y},
              {Type::CaptionMedium, text_of(ui.theme(), meaning)}, label);
  return width;
}

void avatar(Ui& ui, Point centre, float radius, std::string_view initials, int hue) {
  const auto& hues = ui.theme().avatars;
  const auto index = static_cast<std::size_t>(std::abs(hue)) % hues.size();
  ui.canvas().disc(centre, radius, hues[index]);
  ui.canvas().text(centre,
                   {radius > 15.0F ? Type::SmallMedium : Type::CaptionMedium, ui.theme().on_avatar,
                    Align::Centre},
                   initials);
}

float key_chip_width(const Ui& ui, std::string_view key) {
  return std::max(key_height,
                  std::ceil(ui.width_of(Type::CaptionMedium, key)) + 2.0F * key_padding);
}

float key_chip(Ui& ui, Point left_middle, std::string_view key) {
  const float width = key_chip_width(ui, key);
  const Rect rect{left_middle.x, left_middle.y - key_height / 2.0F, width, key_height};
  ui.canvas().fill(rect, ui.theme().raise, 5.0F);
  ui.canvas().outline(rect, ui.theme().line, 5.0F);
  ui.canvas().text_in(rect, {Type::CaptionMedium, ui.theme().text_secondary, Align::Centre}, key);
  return width;
}

void bar(Ui& ui, const Rect& rect, float share) { bar(ui, rect, share, ui.theme().accent); }

void bar(Ui& ui, const Rect& rect, float share, Color color) {
  const float corner = rect.h / 2.0F;
  ui.canvas().fill(rect, ui.theme().chip, corner);
  const float filled = std::clamp(share, 0.0F, 1.0F) * rect.w;
  if (share > 0.0F)
    ui.canvas().fill({rect.x, rect.y, std::max(filled, rect.h), rect.h}, color, corner);
}

void named_bar(Ui& ui, const Rect& line, const NamedBar& named, float name_width) {
  constexpr float value_width = 44.0F, maximum_width = 46.0F, gap = 16.0F;
  Canvas& canvas = ui.canvas();
  Rect rest = line;
  canvas.text_in(take_left(rest, name_width, gap), {Type::Small, ui.theme().text}, named.name);
  canvas.text_in(take_right(rest, maximum_width),
                 {Type::Small, ui.theme().text_caption, Align::Right}, named.maximum);
  canvas.text_in(take_right(rest, value_width), {Type::SmallMedium, ui.theme().text, Align::Right},
                 named.value);
  bar(ui, {rest.x, line.mid_y() - 4.0F, rest.w, 8.0F}, named.share);
}

void score_ring(Ui& ui, Point centre, float radius, const ScoreRing& ring) {
  constexpr float pi = std::numbers::pi_v<float>, top = -pi / 2.0F;
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  canvas.arc(centre, radius, 0.0F, 2.0F * pi, theme.chip, ring_stroke, false);
  const float filled = ui.eased(std::string(ring.id) + ".fill", true, ring_fill_s);
  if (ring.share > 0.0F)
    canvas.arc(centre, radius, top, top + 2.0F * pi * std::min(ring.share, 1.0F) * filled,
               theme.accent, ring_stroke, true);
  if (ring.pass_share >= 0.0F) {
    const float angle = top + 2.0F * pi * ring.pass_share;
    const float inner = radius - ring_stroke / 2.0F - 5.0F,
                outer = radius + ring_stroke / 2.0F + 5.0F;
    canvas.line({centre.x + std::cos(angle) * inner, centre.y + std::sin(angle) * inner},
                {centre.x + std::cos(angle) * outer, centre.y + std::sin(angle) * outer},
                theme.text, 2.0F);
  }
  // All points have a digit more than there is room for.
  const float room = 2.0F * (radius - ring_stroke);
  const bool is_wide = canvas.width_of(Type::Score, ring.number) > room;
  canvas.text({centre.x, centre.y - 3.0F},
              {is_wide ? Type::Number : Type::Score, theme.text, Align::Centre}, ring.number);
  canvas.text({centre.x, centre.y + 31.0F}, {Type::Small, theme.text_caption, Align::Centre},
              ring.below);
}

void meter(Ui& ui, Point left_middle, int filled) {
  for (int block = 0; block < 5; ++block)
    ui.canvas().fill(
        {left_middle.x + 14.0F * static_cast<float>(block), left_middle.y - 3.0F, 10.0F, 6.0F},
        block < filled ? ui.theme().text_secondary : ui.theme().meter_off, 2.0F);
}

}  // namespace hallux::ui
