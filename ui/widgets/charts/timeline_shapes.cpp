// The marks of a timeline. Each is told by its shape; the colour repeats it.
#include <algorithm>
#include <array>
#include <string>

#include "ui/widgets/charts/timeline.h"

namespace hallux::ui {

namespace {

constexpr float note_radius = 9.0F, question_half = 8.0F;

void draw_tick_in(Canvas& canvas, Point at, Color color) {
  const std::array<Point, 3> tick{
      {{at.x - 2.9F, at.y + 0.1F}, {at.x - 0.7F, at.y + 2.3F}, {at.x + 3.0F, at.y - 2.2F}}};
  canvas.polyline(tick, color, 1.6F);
}

void draw_warning(Canvas& canvas, const Theme& theme, Point at) {
  const std::array<Point, 3> shape{
      {{at.x, at.y - 6.5F}, {at.x + 7.0F, at.y + 5.5F}, {at.x - 7.0F, at.y + 5.5F}}};
  canvas.polygon(shape, theme.warn);
  canvas.fill({at.x - 0.8F, at.y - 2.4F, 1.6F, 4.0F}, theme.on_warn, 0.0F);
  canvas.fill({at.x - 0.8F, at.y + 2.6F, 1.6F, 1.6F}, theme.on_warn, 0.0F);
}

void draw_harm(Canvas& canvas, const Theme& theme, Point at) {
  const std::array<Point, 4> shape{
      {{at.x, at.y - 7.0F}, {at.x + 7.0F, at.y}, {at.x, at.y + 7.0F}, {at.x - 7.0F, at.y}}};
  canvas.polygon(shape, theme.bad);
  const std::array<Point, 2> down{{{at.x - 2.0F, at.y - 2.0F}, {at.x + 2.0F, at.y + 2.0F}}};
  const std::array<Point, 2> up{{{at.x - 2.0F, at.y + 2.0F}, {at.x + 2.0F, at.y - 2.0F}}};
  canvas.polyline(down, theme.on_shape, 1.6F);
  canvas.polyline(up, theme.on_shape, 1.6F);
}

void draw_info(Canvas& canvas, const Theme& theme, Point at) {
  canvas.disc(at, 6.0F, theme.accent);
  canvas.fill({at.x - 0.8F, at.y - 0.9F, 1.6F, 4.2F}, theme.on_accent, 0.0F);
  canvas.fill({at.x - 0.8F, at.y - 3.4F, 1.6F, 1.6F}, theme.on_accent, 0.0F);
}

void draw_good(Canvas& canvas, const Theme& theme, Point at) {
  canvas.disc(at, 6.0F, theme.good);
  draw_tick_in(canvas, at, theme.on_shape);
}

Rect square_around(Point at) noexcept {
  return {at.x - question_half, at.y - question_half, 2.0F * question_half, 2.0F * question_half};
}

void draw_question(Canvas& canvas, const Theme& theme, Point at) {
  canvas.fill(square_around(at), theme.card, radius::step);
  canvas.outline(square_around(at), theme.accent, radius::step, 1.5F);
  canvas.text(at, {Type::CaptionMedium, theme.accent, Align::Centre}, "?");
}

void draw_answered(Canvas& canvas, const Theme& theme, Point at) {
  canvas.fill(square_around(at), theme.good, radius::step);
  draw_tick_in(canvas, at, theme.on_shape);
}

void draw_note(Canvas& canvas, const Theme& theme, Point at, std::string_view number) {
  canvas.disc(at, note_radius, theme.accent);
  if (!number.empty())
    canvas.text(at, {Type::CaptionMedium, theme.on_accent, Align::Centre}, number);
}

void draw_cluster(Canvas& canvas, const Theme& theme, Point at, std::string_view count) {
  const float half = std::max(10.0F, 0.5F * canvas.width_of(Type::CaptionMedium, count) + 6.0F);
  const Rect pill{at.x - half, at.y - 9.0F, 2.0F * half, 18.0F};
  canvas.fill(pill, theme.chip, 9.0F);
  canvas.outline(pill, theme.text_caption, 9.0F);
  canvas.text(at, {Type::CaptionMedium, theme.text, Align::Centre}, count);
}

}  // namespace

void draw_timeline_shape(Canvas& canvas, const Theme& theme, TimelineShape shape, Point at,
                         std::string_view label) {
  switch (shape) {
    case TimelineShape::Neutral:
      return canvas.fill({at.x - 1.0F, at.y - 6.0F, 2.0F, 12.0F}, theme.text_caption, 1.0F);
    case TimelineShape::Info:
      return draw_info(canvas, theme, at);
    case TimelineShape::Good:
      return draw_good(canvas, theme, at);
    case TimelineShape::Warn:
      return draw_warning(canvas, theme, at);
    case TimelineShape::Bad:
      return draw_harm(canvas, theme, at);
    case TimelineShape::Note:
      return draw_note(canvas, theme, at, label);
    case TimelineShape::Question:
      return draw_question(canvas, theme, at);
    case TimelineShape::Answered:
      return draw_answered(canvas, theme, at);
    case TimelineShape::Cluster:
      return draw_cluster(canvas, theme, at, label);
    case TimelineShape::Aim:
      return canvas.dashes({at.x - 8.0F, at.y}, {at.x + 8.0F, at.y}, theme.good_text, 4.0F, 4.0F,
                           1.0F);
  }
}

}  // namespace hallux::ui
