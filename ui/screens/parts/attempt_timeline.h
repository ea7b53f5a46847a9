/// What happened in an attempt, as the timelines of result and replay show it.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "scenarios/scenario.h"
#include "simulator/record/record.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

/// Something that happened, as a timeline and a list show it.
struct AttemptEvent {
  double time_s = 0.0;
  Meaning meaning = Meaning::Neutral;
  /// Id of its text.
  std::string_view words;
};

/// In their order; events that nobody reads about are left out.
std::vector<AttemptEvent> events_of(const simulator::Recording& recording);
/// A step lasts from the one before it to when it was declared done; the last one to the end.
std::vector<TimelineStep> steps_of(const simulator::Recording& recording,
                                   const scenarios::Scenario& scenario, double duration_s);
/// Those events as marks, with their words.
std::vector<TimelineEvent> event_marks_of(const Texts& texts,
                                          const std::vector<AttemptEvent>& events);
/// What the marks mean: of events, then of `more`.
std::vector<TimelineKey> legend_of(const Texts& texts, std::initializer_list<TimelineShape> more);
/// The force on the hand; its scale ends above all of it at a round number.
TimelineTrack force_track(const Texts& texts, std::vector<ChartPoint> newton);
/// The next multiple of `step` at or above every point; never below `step`. Gaps are passed over.
double highest_of(const std::vector<ChartPoint>& points, double step) noexcept;
/// Until the last sample; never 0, so that it may be divided by.
double duration_s_of(const simulator::Recording& recording) noexcept;

}  // namespace hallux::ui
