#include "ui/widgets/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hallux::ui {
namespace {

constexpr float half_pi = std::numbers::pi_v<float> / 2.0F;

void draw_warning(Canvas& canvas, const Theme& theme, Point at, float radius) {
  const Point triangle[] = {{at.x, at.y - radius},
                            {at.x + radius * 1.06F, at.y + radius * 0.82F},
                            {at.x - radius * 1.06F, at.y + radius * 0.82F}};
  canvas.polygon(triangle, theme.warn);
  canvas.line({at.x, at.y - radius * 0.38F}, {at.x, at.y + radius * 0.24F}, theme.on_warn,
              radius * 0.26F);
  canvas.disc({at.x, at.y + radius * 0.52F}, radius * 0.15F, theme.on_warn);
}

void draw_harm(Canvas& canvas, const Theme& theme, Point at, float radius) {
  const float reach = radius * 1.12F, cross = radius * 0.3F;
  const Point diamond[] = {
      {at.x, at.y - reach}, {at.x + reach, at.y}, {at.x, at.y + reach}, {at.x - reach, at.y}};
  canvas.polygon(diamond, theme.bad);
  canvas.line({at.x - cross, at.y - cross}, {at.x + cross, at.y + cross}, theme.on_shape,
              radius * 0.26F);
  canvas.line({at.x + cross, at.y - cross}, {at.x - cross, at.y + cross}, theme.on_shape,
              radius * 0.26F);
}

void draw_information(Canvas& canvas, const Theme& theme, Point at, float radius) {
  canvas.disc(at, radius, theme.accent);
  canvas.line({at.x, at.y - radius * 0.08F}, {at.x, at.y + radius * 0.52F}, theme.on_shape,
              radius * 0.26F);
  canvas.disc({at.x, at.y - radius * 0.42F}, radius * 0.16F, theme.on_shape);
}

}  // namespace

void draw_tick(Canvas& canvas, Point centre, float radius, Color color, float thickness) {
  const Point points[] = {{centre.x - radius * 0.48F, centre.y + radius * 0.02F},
                          {centre.x - radius * 0.12F, centre.y + radius * 0.38F},
                          {centre.x + radius * 0.5F, centre.y - radius * 0.36F}};
  canvas.polyline(points, color, thickness);
}

void draw_meaning(Canvas& canvas, const Theme& theme, Meaning meaning, Point centre, float radius) {
  switch (meaning) {
    case Meaning::Good:
      canvas.disc(centre, radius, theme.good);
      draw_tick(canvas, centre, radius, theme.on_shape, radius * 0.26F);
      return;
    case Meaning::Warn:
      draw_warning(canvas, theme, centre, radius);
      return;
    case Meaning::Bad:
      draw_harm(canvas, theme, centre, radius);
      return;
    case Meaning::Info:
      draw_information(canvas, theme, centre, radius);
      return;
    case Meaning::Neutral:
      canvas.ring(centre, radius - 1.0F, theme.text_caption, 1.5F);
      return;
  }
}

void draw_competence(Canvas& canvas, const Theme& theme, Competence competence, Point centre,
                     float radius, float progress) {
  switch (competence) {
    case Competence::NotStarted:
      canvas.fill({centre.x - 5.0F, centre.y - 1.0F, 10.0F, 2.0F}, theme.text_caption, 1.0F);
      return;
    case Competence::Learning:
      canvas.ring(centre, radius - 1.0F, theme.ring_track, 2.5F);
      if (progress > 0.0F)
        canvas.arc(centre, radius - 1.0F, -half_pi, -half_pi + 4.0F * half_pi * progress,
                   theme.accent, 2.5F, false);
      return;
    case Competence::Competent:
      draw_meaning(canvas, theme, Meaning::Good, centre, radius);
      return;
    case Competence::Slipped: {
      const float reach = radius * 1.02F;
      const Point triangle[] = {{centre.x - reach, centre.y - reach * 0.75F},
                                {centre.x + reach, centre.y - reach * 0.75F},
                                {centre.x, centre.y + reach}};
      canvas.polygon(triangle, theme.bad);
      return;
    }
    case Competence::Stale: {
      canvas.ring(centre, radius - 1.0F, theme.text_secondary, 1.5F);
      const Point hands[] = {
          {centre.x, centre.y - radius * 0.58F}, centre, {centre.x + radius * 0.42F, centre.y}};
      canvas.polyline(hands, theme.text_secondary, 1.5F);
      return;
    }
  }
}

void draw_spinner(Canvas& canvas, Point centre, float radius, Color color) {
  canvas.ring(centre, radius, faded(color, 0.25F), 2.0F);
  canvas.arc(centre, radius, -half_pi, 0.4F, color, 2.0F, true);
}

void draw_logo(Canvas& canvas, const Theme& theme, Point centre, float size) {
  canvas.arc(centre, size * 0.70F, -0.12F, 5.62F, theme.accent, size * 0.60F, false);
  canvas.disc(centre, size * 0.16F, theme.accent);
}

void draw_focus_ring(Canvas& canvas, const Theme& theme, const Rect& rect, float corner) {
  canvas.outline(inset(rect, -3.0F), theme.focus, corner + 3.0F, 2.0F);
}

void draw_shadow(Canvas& canvas, const Theme& theme, const Rect& rect, float corner,
                 Elevation elevation) {
  const bool is_popup = elevation == Elevation::Popup;
  if (theme.is_dark() && !is_popup) return;
  const int rings = !is_popup ? 3 : theme.is_dark() ? 10 : 9;
  const float step = is_popup ? 1.9F : 1.0F, drop = is_popup ? 4.0F : 1.0F;
  // Few rings of pure black: coloured ones of so little alpha would be rounded to another hue.
  const Color black{0, 0, 0, static_cast<std::uint8_t>(theme.is_dark() ? 9 : 2)};
  for (int ring = rings; ring > 0; --ring) {
    const float reach = static_cast<float>(ring) * step;
    canvas.fill(moved(inset(rect, -reach), 0.0F, drop), black, corner + reach);
  }
}

void draw_card(Canvas& canvas, const Theme& theme, const Rect& rect, float corner) {
  draw_shadow(canvas, theme, rect, corner, Elevation::Card);
  canvas.fill(rect, theme.card, corner);
  canvas.outline(rect, theme.line, corner);
}

void draw_popup(Canvas& canvas, const Theme& theme, const Rect& rect, float corner) {
  draw_shadow(canvas, theme, rect, corner, Elevation::Popup);
  canvas.fill(rect, theme.popup, corner);
  canvas.outline(rect, theme.popup_border, corner);
}

void draw_told_words(Canvas& canvas, const Theme& theme, const Rect& beside,
                     std::string_view words) {
  constexpr float widest = 440.0F, padding = 12.0F, distance = 6.0F, edge = 4.0F;
  const LayerScope layer(canvas, Layer::Tooltip);
  const Rect display = canvas.display();
  const float room = std::min(widest, display.w - 2.0F * (edge + padding));
  const float width = std::min(room, std::ceil(canvas.width_of(Type::Small, words)) + 1.0F);
  const float height = canvas.paragraph_height(Type::Small, words, width);
  Rect popup{beside.x - padding, beside.bottom() + distance, width + 2.0F * padding,
             height + 16.0F};
  popup.x = std::clamp(popup.x, edge, std::max(edge, display.right() - popup.w - edge));
  if (popup.bottom() > display.bottom() - edge)
    popup.y = std::max(edge, beside.y - distance - popup.h);
  draw_popup(canvas, theme, popup, radius::control);
  canvas.paragraph({popup.x + padding, popup.y + 8.0F, width, height}, {Type::Small, theme.text},
                   words);
}

void draw_hud_panel(Canvas& canvas, const Theme& theme, const Rect& rect, float corner) {
  canvas.fill(rect, theme.hud, corner);
  canvas.outline(rect, theme.hud_border, corner);
}

}  // namespace hallux::ui
