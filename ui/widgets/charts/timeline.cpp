// An attempt along its time: steps, events, notes, curves over one axis, with names at the left.
// Every row has a fixed height, so that a pixel means the same moment in all of them and `time_at`
// is one division. What lies outside the range is clipped, not left out: a curve leaves through the
// edge.
#include "ui/widgets/charts/timeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hallux::ui {
namespace {

constexpr float names_room = 124.0F, steps_height = 24.0F, events_top = 42.0F, notes_step = 26.0F,
                compact_step = 20.0F, compact_gap = 14.0F, tracks_gap = 22.0F, track_step = 62.0F,
                track_height = 48.0F, axis_height = 20.0F, overview_height = 10.0F,
                overview_gap = 4.0F, end_room = 8.0F, head_room = 12.0F;
constexpr float neutral_half = 2.0F, mark_half = 8.0F, note_half = 10.0F;
constexpr float head_half = 7.0F, axis_label_room = 64.0F;

float notes_step_of(const Timeline& timeline) noexcept {
  return timeline.is_compact ? compact_step : notes_step;
}

float rows_height(const Timeline& timeline) noexcept {
  const float notes = timeline.notes_name.empty() ? 0.0F : notes_step_of(timeline);
  return events_top + notes + (timeline.is_compact ? compact_gap : tracks_gap);
}

float strip_height(const Timeline& timeline) noexcept {
  return timeline.is_compact ? 0.0F : overview_gap + overview_height;
}

void draw_steps(Canvas& canvas, const Theme& theme, const Rect& rect, const TimelineLayout& layout,
                const Timeline& timeline) {
  const Plot& plot = layout.plot;
  const float middle = layout.steps.mid_y();
  canvas.text({rect.x, middle}, {Type::Caption, theme.text_secondary, Align::Left},
              timeline.steps_name);
  for (const TimelineStep& step : timeline.steps) {
    const bool is_now =
        timeline.now_s && step.begin_s <= *timeline.now_s && *timeline.now_s < step.end_s;
    const float left = std::max(plot.x(step.begin_s), plot.rect.x) + 1.0F;
    const float right = std::min(plot.x(step.end_s), plot.rect.right()) - 1.0F;
    if (right <= left) continue;
    const Rect band{left, layout.steps.y, right - left, steps_height};
    canvas.fill(band, is_now ? theme.accent_soft : theme.raise, radius::step);
    const Type type = is_now ? Type::CaptionMedium : Type::Caption;
    if (canvas.width_of(type, step.name) + 8.0F <= band.w)
      canvas.text({band.mid_x(), middle},
                  {type, is_now ? theme.accent : theme.text_secondary, Align::Centre}, step.name);
  }
}

/// The samples of what is shown, and one beyond it at each side.
std::span<const ChartPoint> in_sight(const std::vector<ChartPoint>& samples, const Plot& plot) {
  const auto by_time = [](const ChartPoint& point, double time_s) { return point.x < time_s; };
  auto first = std::lower_bound(samples.begin(), samples.end(), plot.x_low, by_time);
  auto last = std::lower_bound(first, samples.end(), plot.x_high, by_time);
  if (first != samples.begin()) --first;
  if (last != samples.end()) ++last;
  return {first, last};
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
  const ClipScope clip(canvas, inset(plot.rect, 0.0F, -2.0F));
  for (const std::vector<Point>& run : line_runs(plot, in_sight(track.samples, plot)))
    canvas.polyline(run, theme.accent, 1.5F);
}

void draw_playhead(Canvas& canvas, const Theme& theme, const Plot& plot, double now_s,
                   float bottom) {
  const float now = std::round(plot.x(now_s));
  if (now < plot.rect.x - 1.0F || now > plot.rect.right() + 1.0F) return;
  canvas.fill({now - 1.0F, plot.rect.y - 4.0F, 2.0F, bottom - plot.rect.y - 6.0F}, theme.text,
              1.0F);
  const std::array<Point, 3> head{{{now - head_half, plot.rect.y - 11.0F},
                                   {now + head_half, plot.rect.y - 11.0F},
                                   {now, plot.rect.y - 2.0F}}};
  canvas.polygon(head, theme.text);
}

double axis_step_s(double span_s, float width) {
  for (const double step :
       {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0})
    if (span_s / step * static_cast<double>(axis_label_room) <= static_cast<double>(width))
      return step;
  return 1800.0;
}

void draw_axis(Canvas& canvas, const Theme& theme, const TimelineLayout& layout) {
  const Plot& plot = layout.plot;
  const double step_s = axis_step_s(plot.x_high - plot.x_low, plot.rect.w);
  const double slack_s = 1.0e-6 * step_s;
  for (double number = std::ceil((plot.x_low - slack_s) / step_s);
       number * step_s <= plot.x_high + slack_s; number += 1.0) {
    const double time_s = number * step_s;
    canvas.text({plot.x(time_s), layout.axis_y}, {Type::Caption, theme.text_caption, Align::Centre},
                step_s < 1.0 ? clock_tenths_text(time_s) : clock_text(time_s));
  }
}

/// Where in all of the time it is.
void draw_overview(Canvas& canvas, const Theme& theme, const Rect& rect, const Timeline& timeline) {
  Plot all;
  all.rect = rect;
  all.x_high = std::max(timeline.duration_s, 0.001);
  canvas.fill(rect, theme.raise, 3.0F);
  const TimeRange range = range_of(timeline);
  const float left = all.x(range.begin_s);
  const Rect shown{left, rect.y, std::max(all.x(range.end_s) - left, 4.0F), rect.h};
  canvas.fill(shown, theme.accent_soft, 3.0F);
  for (const TimelineEvent& event : timeline.events)
    canvas.fill(
        {std::round(all.x(event.time_s)), rect.y + 3.0F, 1.0F, rect.h - 6.0F},
        event.meaning == Meaning::Neutral ? theme.text_caption : fill_of(theme, event.meaning),
        0.0F);
  canvas.outline(shown, theme.accent, 3.0F, 1.5F);
  if (timeline.now_s)
    canvas.fill({std::round(all.x(*timeline.now_s)) - 1.0F, rect.y, 2.0F, rect.h}, theme.text,
                1.0F);
}

/// Places of those in sight; `first` becomes the first of them.
template <typename Item, typename HalfWidth>
std::vector<PlacedMark> placed_marks(const Plot& plot, const std::vector<Item>& items,
                                     HalfWidth half_width, std::size_t& first) {
  std::vector<PlacedMark> marks;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].time_s < plot.x_low || items[i].time_s > plot.x_high) continue;
    if (marks.empty()) first = i;
    marks.push_back({plot.x(items[i].time_s), half_width(items[i])});
  }
  return marks;
}

std::vector<MarkCluster> clusters_from(std::span<const PlacedMark> marks, std::size_t first) {
  std::vector<MarkCluster> clusters = clustered(marks);
  for (MarkCluster& cluster : clusters) cluster.first += first;
  return clusters;
}

TimelineShape shape_of(Meaning meaning) noexcept {
  switch (meaning) {
    case Meaning::Good:
      return TimelineShape::Good;
    case Meaning::Warn:
      return TimelineShape::Warn;
    case Meaning::Bad:
      return TimelineShape::Bad;
    case Meaning::Info:
      return TimelineShape::Info;
    case Meaning::Neutral:
      break;
  }
  return TimelineShape::Neutral;
}

/// The gravest of a cluster stands at its corner; what is good or neutral needs no sign there.
TimelineShape gravest(const Timeline& timeline, const MarkCluster& cluster) noexcept {
  TimelineShape shape = TimelineShape::Neutral;
  for (std::size_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
    const Meaning meaning = timeline.events[i].meaning;
    if (meaning == Meaning::Bad) return TimelineShape::Bad;
    if (meaning == Meaning::Warn) shape = TimelineShape::Warn;
  }
  return shape;
}

void draw_events(Canvas& canvas, const Theme& theme, const TimelineLayout& layout,
                 const Timeline& timeline) {
  for (const MarkCluster& cluster : event_marks(layout, timeline)) {
    const Point at{cluster.x, layout.events_y};
    if (cluster.count == 1) {
      draw_timeline_shape(canvas, theme, shape_of(timeline.events[cluster.first].meaning), at);
      continue;
    }
    draw_timeline_shape(canvas, theme, TimelineShape::Cluster, at, std::to_string(cluster.count));
    const TimelineShape worst = gravest(timeline, cluster);
    if (worst != TimelineShape::Neutral)
      draw_timeline_shape(canvas, theme, worst, {at.x + cluster.half_width - 3.0F, at.y - 9.0F});
  }
}

void draw_notes(Canvas& canvas, const Theme& theme, const TimelineLayout& layout,
                const Timeline& timeline) {
  for (const MarkCluster& cluster : note_marks(layout, timeline)) {
    const Point at{cluster.x, layout.notes_y};
    const TimelineNote& note = timeline.notes[cluster.first];
    const bool is_one = cluster.count == 1;
    draw_timeline_shape(canvas, theme, is_one ? note.shape : TimelineShape::Cluster, at,
                        is_one ? note.number : std::to_string(cluster.count));
  }
}

void draw_line_of(Canvas& canvas, const Theme& theme, const Rect& rect, const Plot& plot, float y,
                  std::string_view name) {
  canvas.text({rect.x, y}, {Type::Caption, theme.text_secondary, Align::Left}, name);
  canvas.fill({plot.rect.x, std::round(y), plot.rect.w, 1.0F}, theme.line, 0.0F);
}

}  // namespace

TimeRange range_of(const Timeline& timeline) noexcept {
  return timeline.range.value_or(TimeRange{0.0, std::max(timeline.duration_s, 0.001)});
}

TimelineLayout layout_of(const Rect& rect, const Timeline& timeline) noexcept {
  TimelineLayout layout;
  const TimeRange range = range_of(timeline);
  const float x = rect.x + names_room, y = rect.y + head_room;
  const float width = std::max(1.0F, rect.w - names_room - end_room);
  const float tracks = track_step * static_cast<float>(timeline.tracks.size());
  layout.steps = {x, y, width, steps_height};
  layout.events_y = y + events_top;
  layout.notes_y = layout.events_y + notes_step_of(timeline);
  layout.tracks_top = y + rows_height(timeline);
  layout.axis_y = layout.tracks_top + tracks + 6.0F;
  layout.overview = {x, layout.tracks_top + tracks + axis_height + overview_gap, width,
                     timeline.is_compact ? 0.0F : overview_height};
  layout.plot.rect = {x, y, width, layout.tracks_top + tracks - y};
  layout.plot.x_low = range.begin_s;
  layout.plot.x_high = range.end_s;
  return layout;
}

float timeline_height(const Timeline& timeline) noexcept {
  return head_room + rows_height(timeline) +
         track_step * static_cast<float>(timeline.tracks.size()) + axis_height +
         strip_height(timeline);
}

double time_at(const Rect& rect, const Timeline& timeline, float x) noexcept {
  const TimeRange range = range_of(timeline);
  return std::clamp(layout_of(rect, timeline).plot.value_at(x), range.begin_s, range.end_s);
}

std::vector<MarkCluster> event_marks(const TimelineLayout& layout, const Timeline& timeline) {
  std::size_t first = 0;
  const auto half_width = [](const TimelineEvent& event) {
    return event.meaning == Meaning::Neutral ? neutral_half : mark_half;
  };
  return clusters_from(placed_marks(layout.plot, timeline.events, half_width, first), first);
}

std::vector<MarkCluster> note_marks(const TimelineLayout& layout, const Timeline& timeline) {
  if (timeline.notes_name.empty()) return {};
  std::size_t first = 0;
  const auto half_width = [](const TimelineNote&) { return note_half; };
  return clusters_from(placed_marks(layout.plot, timeline.notes, half_width, first), first);
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

std::string clock_tenths_text(double time_s) {
  // A tenth that is one but for a rounding is that tenth.
  const auto tenths = static_cast<long>(std::floor(std::max(time_s, 0.0) * 10.0 + 1.0e-6));
  const long seconds = tenths / 10;
  return clock_text(static_cast<double>(seconds)) + "." + std::to_string(tenths % 10);
}

void draw_timeline(Canvas& canvas, const Theme& theme, const Rect& rect, const Timeline& timeline) {
  const TimelineLayout layout = layout_of(rect, timeline);
  draw_steps(canvas, theme, rect, layout, timeline);
  draw_line_of(canvas, theme, rect, layout.plot, layout.events_y, timeline.events_name);
  if (!timeline.notes_name.empty())
    draw_line_of(canvas, theme, rect, layout.plot, layout.notes_y, timeline.notes_name);
  float top = layout.tracks_top;
  for (const TimelineTrack& track : timeline.tracks) {
    draw_track(canvas, theme, rect, layout.plot, track, top);
    top += track_step;
  }
  draw_axis(canvas, theme, layout);
  draw_events(canvas, theme, layout, timeline);
  if (timeline.now_s) draw_playhead(canvas, theme, layout.plot, *timeline.now_s, top);
  draw_notes(canvas, theme, layout, timeline);
  if (!timeline.is_compact) draw_overview(canvas, theme, layout.overview, timeline);
}

}  // namespace hallux::ui
