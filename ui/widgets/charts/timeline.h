/// The time of an attempt: its steps, events, notes and measured tracks over one axis, with the
/// playhead.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/canvas.h"
#include "ui/widgets/charts/axis.h"
#include "ui/widgets/look/theme.h"

namespace hallux::ui {

struct TimelineStep {
  double begin_s = 0.0, end_s = 0.0;
  std::string name = {};
};

struct TimelineEvent {
  double time_s = 0.0;
  /// Neutral: a plain tick.
  Meaning meaning = Meaning::Neutral;
};

struct TimelineNote {
  double time_s = 0.0;
  std::string number = {};
};

struct TimelineTrack {
  /// "Force" and "N, aim <= 15".
  std::string name = {}, unit = {};
  /// x in seconds.
  std::vector<ChartPoint> samples = {};
  /// The scale goes from `low` to this.
  double high = 1.0;
  /// Good below it.
  std::optional<double> aim = {};
  double low = 0.0;
};

struct Timeline {
  double duration_s = 1.0;
  /// The playhead; none where nothing is being played.
  std::optional<double> now_s = 0.0;
  std::string steps_name = {}, events_name = {};
  std::vector<TimelineStep> steps = {};
  std::vector<TimelineEvent> events = {};
  std::vector<TimelineNote> notes = {};
  std::vector<TimelineTrack> tracks = {};
};

void draw_timeline(Canvas& canvas, const Theme& theme, const Rect& rect, const Timeline& timeline);

/// The height that steps, events, tracks and the axis take.
float timeline_height(const Timeline& timeline) noexcept;

/// The moment under `x` when the timeline is drawn into `rect`, inside [0, duration].
double time_at(const Rect& rect, const Timeline& timeline, float x) noexcept;

/// 02:31 for 151 s; 1:02:31 above an hour.
std::string clock_text(double time_s);

}  // namespace hallux::ui
