// An attempt along its time: steps, events, notes, curves over one axis, with names at the left.
// Every row has a fixed height, so that a pixel means the same moment in all of them and `time_at`
// is one division. Events are drawn as the shapes of their meaning, smaller than elsewhere.
#include "ui/widgets/charts/timeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hallux::ui {
namespace {

constexpr float names_room = 124.0F, steps_height = 24.0F, events_top = 42.0F, tracks_top = 64.0F,
                track_step = 62.0F, track_height = 48.0F, axis_height = 24.0F, end_room = 8.0F,
                head_room = 12.0F;

Plot plot_of(const Rect& rect, const Timeline& timeline) {
  Plot plot;
  plot.rect = {rect.x + names_room, rect.y + head_room,
               std::max(1.0F, rect.w - names_room - end_room), rect.h - head_room};
  plot.x_high = std::max(timeline.duration_s, 0.001);
  return plot;
}

void draw_steps(Canvas& canvas, const Theme& theme, const Rect& rect, const Plot& plot,
                const Timeline& timeline) {
  const float middle = plot.rect.y + steps_height / 2.0F;
  canvas.text({rect.x, middle}, {Type::Caption, theme.text_secondary, Align::Left},
              timeline.steps_name);
  for (const TimelineStep& step : timeline.steps) {
    const bool is_now =
        timeline.now_s && step.begin_s <= *timeline.now_s && *timeline.now_s < step.end_s;
    const Rect band{plot.x(step.begin_s) + 1.0F, plot.rect.y,
                    plot.x(step.end_s) - plot.x(step.begin_s) - 2.0F, steps_height};
    canvas.fill(band, is_now ? theme.accent_soft : theme.raise, radius::step);
    const Type type = is_now ? Type::CaptionMedium : Type::Caption;
    if (canvas.width_of(type, step.name) + 8.0F <= band.w)
      canvas.text({band.mid_x(), middle},
                  {type, is_now ? theme.accent : theme.text_secondary, Align::Centre}, step.name);
  }
}

void draw_event(Canvas& canvas, const Theme& theme, Point at, Meaning meaning) {
  switch (meaning) {
    case Meaning::Neutral:
      canvas.fill({at.x - 1.0F, at.y - 6.0F, 2.0F, 12.0F}, theme.text_caption, 1.0F);
      return;
    case Meaning::Warn: {
      const std::array<Point, 3> shape{
          {{at.x, at.y - 6.5F}, {at.x + 7.0F, at.y + 5.5F}, {at.x - 7.0F, at.y + 5.5F}}};
      canvas.polygon(shape, theme.warn);
      canvas.fill({at.x - 0.8F, at.y - 2.4F, 1.6F, 4.0F}, theme.on_warn, 0.0F);
      canvas.fill({at.x - 0.8F, at.y + 2.6F, 1.6F, 1.6F}, theme.on_warn, 0.0F);
      return;
    }
    case Meaning::Bad: {
      const std::array<Point, 4> shape{
          {{at.x, at.y - 7.0F}, {at.x + 7.0F, at.y}, {at.x, at.y + 7.0F}, {at.x - 7.0F, at.y}}};
      canvas.polygon(shape, theme.bad);
      const std::array<Point, 2> down{{{at.x - 2.0F, at.y - 2.0F}, {at.x + 2.0F, at.y + 2.0F}}};
      const std::array<Point, 2> up{{{at.x - 2.0F, at.y + 2.0F}, {at.x + 2.0F, at.y - 2.0F}}};
      canvas.polyline(down, theme.on_shape, 1.6F);
      canvas.polyline(up, theme.on_shape, 1.6F);
      return;
    }
    case Meaning::Good:
    case Meaning::Info: {
      canvas.disc(at, 6.0F, meaning == Meaning::Good ? theme.good : theme.accent);
      const std::array<Point, 3> tick{
          {{at.x - 2.9F, at.y + 0.1F}, {at.x - 0.7F, at.y + 2.3F}, {at.x + 3.0F, at.y - 2.2F}}};
      canvas.polyline(tick, theme.on_shape, 1.6F);
      return;
    }
  }
}

void draw_track(Canvas& canvas, const Theme& theme, const Rect& rect, const Plot& whole,
                const TimelineTrack& track, float top) {
  Plot plot = whole;
  plot.rect.y = top;
  plot.rect.h = track_height;
  plot.y_low = track.low;
  plot.y_high = track.high;
  canvas.text({rect.x, top + 9.0F}, {Type::Caption, theme.text_secondary, Align::Left}, track.name);
  canvas.text({rect.x, top + 27.0F}, {Type::Caption, theme.text_caption, Align::Left}, track.unit);
  const double middle = 0.5 * (track.low + track.high);
  for (const double value : {track.low, middle, track.high}) {
    canvas.fill({plot.rect.x, std::round(plot.y(value)), plot.rect.w, 1.0F},
                value == track.low ? theme.axis : theme.line, 0.0F);
    canvas.text({plot.rect.x - 10.0F, plot.y(value)},
                {Type::Caption, theme.text_caption, Align::Right},
                tick_text(value, 0.5 * (track.high - track.low)));
  }
  if (track.aim) {
    const float y = plot.y(std::min(*track.aim, track.high));
    canvas.fill({plot.rect.x, y, plot.rect.w, plot.rect.bottom() - y}, faded(theme.good, 0.10F),
                0.0F);
    canvas.dashes({plot.rect.x, y}, {plot.rect.right(), y}, theme.good_text, 4.0F, 4.0F, 1.0F);
  }
  for (const std::vector<Point>& run : line_runs(plot, track.samples))
    canvas.polyline(run, theme.accent, 1.5F);
}

void draw_playhead(Canvas& canvas, const Theme& theme, const Plot& plot, double now_s,
                   float bottom) {
  const float now = std::round(plot.x(now_s));
  canvas.fill({now - 1.0F, plot.rect.y - 4.0F, 2.0F, bottom - plot.rect.y - 6.0F}, theme.text,
              1.0F);
  const std::array<Point, 3> head{{{now - 7.0F, plot.rect.y - 11.0F},
                                   {now + 7.0F, plot.rect.y - 11.0F},
                                   {now, plot.rect.y - 2.0F}}};
  canvas.polygon(head, theme.text);
}

double axis_step_s(double duration_s, float width) {
  for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0})
    if (duration_s / step * 64.0 <= static_cast<double>(width)) return step;
  return 1800.0;
}

}  // namespace

float timeline_height(const Timeline& timeline) noexcept {
  return head_room + tracks_top + track_step * static_cast<float>(timeline.tracks.size()) +
         axis_height;
}

double time_at(const Rect& rect, const Timeline& timeline, float x) noexcept {
  return std::clamp(plot_of(rect, timeline).value_at(x), 0.0, timeline.duration_s);
}

std::string clock_text(double time_s) {
  const long seconds = static_cast<long>(std::floor(std::max(time_s, 0.0)));
  char text[32];
  if (seconds >= 3600)
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", seconds / 3600, seconds / 60 % 60,
                  seconds % 60);
  else
    std::snprintf(text, sizeof text, "%02ld:%02ld", seconds / 60, seconds % 60);
  return text;
}

void draw_timeline(Canvas& canvas, const Theme& theme, const Rect& rect, const Timeline& timeline) {
  const Plot plot = plot_of(rect, timeline);
  draw_steps(canvas, theme, rect, plot, timeline);
  const float events = plot.rect.y + events_top;
  canvas.text({rect.x, events}, {Type::Caption, theme.text_secondary, Align::Left},
              timeline.events_name);
  canvas.fill({plot.rect.x, std::round(events), plot.rect.w, 1.0F}, theme.line, 0.0F);
  for (const TimelineEvent& event : timeline.events)
    draw_event(canvas, theme, {plot.x(event.time_s), events}, event.meaning);
  float top = plot.rect.y + tracks_top;
  for (const TimelineTrack& track : timeline.tracks) {
    draw_track(canvas, theme, rect, plot, track, top);
    top += track_step;
  }
  const double step = axis_step_s(timeline.duration_s, plot.rect.w);
  for (double time_s = 0.0; time_s <= timeline.duration_s; time_s += step)
    canvas.text({plot.x(time_s), top + 6.0F}, {Type::Caption, theme.text_caption, Align::Centre},
                clock_text(time_s));
  if (timeline.now_s) draw_playhead(canvas, theme, plot, *timeline.now_s, top);
  for (const TimelineNote& note : timeline.notes) {
    canvas.disc({plot.x(note.time_s), events}, 9.0F, theme.accent);
    canvas.text({plot.x(note.time_s), events},
                {Type::CaptionMedium, theme.on_accent, Align::Centre}, note.number);
  }
}

}  // namespace hallux::ui
