/// The time of an attempt: its steps, events, notes and measured tracks over one axis, with the
/// playhead. All of it or a part is shown; marks that would lie over each other are one with their
/// number. Below the axis a strip shows which part of all it is.
///
///     Steps    | Verify |   Cut 1      |  Cut 2   |
///     Events   --i----(12)------^----------<x>-----
///     Notes    ----1-----------------?-------------
///     Force    ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
///              06:20     06:30     06:40     06:50
///              [..........====.....................]
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/canvas.h"
#include "ui/widgets/charts/axis.h"
#include "ui/widgets/charts/mark_clusters.h"
#include "ui/widgets/charts/time_range.h"
#include "ui/widgets/look/theme.h"

namespace hallux::ui {

struct TimelineStep {
  double begin_s = 0.0, end_s = 0.0;
  std::string name = {};
};

/// What stands on a timeline, each by a shape of its own.
enum class TimelineShape : std::uint8_t {
  Neutral,
  Info,
  Good,
  Warn,
  Bad,
  Note,
  Question,
  Answered,
  Cluster,
  Aim
};

struct TimelineEvent {
  double time_s = 0.0;
  /// Neutral: a plain tick.
  Meaning meaning = Meaning::Neutral;
  std::string words = {};
};

struct TimelineNote {
  double time_s = 0.0;
  /// On a note.
  std::string number = {};
  std::string words = {};
  /// Note, Question or Answered.
  TimelineShape shape = TimelineShape::Note;
};

struct TimelineTrack {
  /// "Force" and "N, aim <= 15".
  std::string name = {}, unit = {};
  /// x in seconds, ascending.
  std::vector<ChartPoint> samples = {};
  /// The scale goes from `low` to this.
  double high = 1.0;
  /// Good below it.
  std::optional<double> aim = {};
  double low = 0.0;
};

/// A line of the legend.
struct TimelineKey {
  TimelineShape shape = TimelineShape::Neutral;
  std::string words = {};
};

struct Timeline {
  double duration_s = 1.0;
  /// Nothing: all of it.
  std::optional<TimeRange> range = {};
  /// The playhead; none where nothing is being played.
  std::optional<double> now_s = 0.0;
  std::string steps_name = {}, events_name = {};
  /// Empty: no line for notes.
  std::string notes_name = {};
  std::vector<TimelineStep> steps = {};
  /// By time; notes as well.
  std::vector<TimelineEvent> events = {};
  std::vector<TimelineNote> notes = {};
  std::vector<TimelineTrack> tracks = {};
  std::vector<TimelineKey> legend = {};
  /// In a low window: the strip is left out, the lines stand closer.
  bool is_compact = false;
};

/// Where the parts of a timeline stand in its rectangle.
struct TimelineLayout {
  /// x is the time that is shown; from the steps down to the tracks.
  Plot plot;
  Rect steps;
  float events_y = 0.0F, notes_y = 0.0F, tracks_top = 0.0F, axis_y = 0.0F;
  /// Of all of the time; empty where it is compact.
  Rect overview;
};
TimelineLayout layout_of(const Rect& rect, const Timeline& timeline) noexcept;

void draw_timeline(Canvas& canvas, const Theme& theme, const Rect& rect, const Timeline& timeline);

/// The height that steps, events, notes, tracks, the axis and the strip take.
float timeline_height(const Timeline& timeline) noexcept;

TimeRange range_of(const Timeline& timeline) noexcept;
/// The moment under `x` when the timeline is drawn into `rect`, inside what is shown.
double time_at(const Rect& rect, const Timeline& timeline, float x) noexcept;

/// Events and notes in sight, as they are drawn; `first` is one of all of them.
std::vector<MarkCluster> event_marks(const TimelineLayout& layout, const Timeline& timeline);
std::vector<MarkCluster> note_marks(const TimelineLayout& layout, const Timeline& timeline);

/// `label` is a note's number, or that of a cluster.
void draw_timeline_shape(Canvas& canvas, const Theme& theme, TimelineShape shape, Point centre,
                         std::string_view label = {});

/// 02:31 for 151 s; 1:02:31 above an hour. With tenths: 02:31.4.
std::string clock_text(double time_s);
std::string clock_tenths_text(double time_s);

}  // namespace hallux::ui
