#include "ui/screens/parts/attempt_timeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::Recording;

constexpr double least_duration_s = 0.001;
constexpr double rounded_force_up_to = 5.0;

struct EventText {
  CutEventKind kind;
  Meaning meaning;
  std::string_view words;
};
constexpr EventText event_texts[] = {
    {CutEventKind::Started, Meaning::Neutral, "replay.event.started"},
    {CutEventKind::Scratch, Meaning::Warn, "replay.event.scratch"},
    {CutEventKind::Kick, Meaning::Warn, "replay.event.kick"},
    {CutEventKind::PlaneFrozen, Meaning::Info, "replay.event.plane_frozen"},
    {CutEventKind::Breakthrough, Meaning::Neutral, "replay.event.breakthrough"},
    {CutEventKind::SectionCovered, Meaning::Good, "replay.event.section_covered"},
    {CutEventKind::PieceFreed, Meaning::Good, "replay.event.piece_freed"},
    {CutEventKind::PieceRemoved, Meaning::Neutral, "replay.event.piece_removed"},
    {CutEventKind::StepDone, Meaning::Neutral, "replay.event.step_done"},
    {CutEventKind::StepReopened, Meaning::Neutral, "replay.event.step_reopened"},
    {CutEventKind::Paused, Meaning::Neutral, "replay.event.paused"},
    {CutEventKind::Resumed, Meaning::Neutral, "replay.event.resumed"},
    {CutEventKind::Fault, Meaning::Bad, "replay.event.fault"},
    {CutEventKind::Finished, Meaning::Good, "replay.event.finished"},
    {CutEventKind::Abandoned, Meaning::Warn, "replay.event.abandoned"},
    {CutEventKind::KerfRefused, Meaning::Warn, "replay.event.kerf_refused"},
    {CutEventKind::HingeClosed, Meaning::Good, "replay.event.hinge_closed"},
    {CutEventKind::HingeRefused, Meaning::Bad, "replay.event.hinge_refused"},
    {CutEventKind::BoneHot, Meaning::Warn, "replay.event.bone_hot"},
    {CutEventKind::BoneNecrosis, Meaning::Bad, "replay.event.bone_necrosis"},
    {CutEventKind::DangerContact, Meaning::Bad, "replay.event.danger_contact"},
    {CutEventKind::DangerLeft, Meaning::Neutral, "replay.event.danger_left"},
    {CutEventKind::FragmentParted, Meaning::Neutral, "replay.event.fragment_parted"},
    {CutEventKind::Gripped, Meaning::Info, "replay.event.gripped"},
    {CutEventKind::Released, Meaning::Neutral, "replay.event.released"},
    {CutEventKind::GripRefused, Meaning::Warn, "replay.event.grip_refused"},
    {CutEventKind::ToolChosen, Meaning::Neutral, "replay.event.tool_chosen"},
    {CutEventKind::ToolRefused, Meaning::Warn, "replay.event.tool_refused"},
    {CutEventKind::BoreBegun, Meaning::Info, "replay.event.bore_begun"},
    {CutEventKind::BoreRefused, Meaning::Warn, "replay.event.bore_refused"},
    {CutEventKind::BoreThrough, Meaning::Neutral, "replay.event.bore_through"},
    {CutEventKind::MetalMet, Meaning::Bad, "replay.event.metal_met"},
    {CutEventKind::ScrewSeated, Meaning::Good, "replay.event.screw_seated"},
    {CutEventKind::ImplantLeft, Meaning::Good, "replay.event.implant_left"},
    {CutEventKind::ImplantTaken, Meaning::Neutral, "replay.event.implant_taken"},
    {CutEventKind::ImplantRefused, Meaning::Warn, "replay.event.implant_refused"},
};

constexpr std::pair<TimelineShape, std::string_view> shape_texts[] = {
    {TimelineShape::Neutral, "timeline.legend.neutral"},
    {TimelineShape::Info, "timeline.legend.info"},
    {TimelineShape::Good, "timeline.legend.good"},
    {TimelineShape::Warn, "timeline.legend.warn"},
    {TimelineShape::Bad, "timeline.legend.bad"},
    {TimelineShape::Note, "timeline.legend.note"},
    {TimelineShape::Question, "timeline.legend.question"},
    {TimelineShape::Answered, "timeline.legend.answered"},
    {TimelineShape::Cluster, "timeline.legend.cluster"},
    {TimelineShape::Aim, "timeline.legend.aim"},
};

}  // namespace

std::vector<AttemptEvent> events_of(const Recording& recording) {
  std::vector<AttemptEvent> events;
  for (const CutEvent& event : recording.events) {
    const auto* words =
        std::find_if(std::begin(event_texts), std::end(event_texts),
                     [&](const EventText& each) { return each.kind == event.kind; });
    if (words == std::end(event_texts)) continue;
    events.push_back({second_from_tick(event.tick), words->meaning, words->words});
  }
  return events;
}

std::vector<TimelineStep> steps_of(const Recording& recording, const scenarios::Scenario& scenario,
                                   double duration_s) {
  std::vector<TimelineStep> steps;
  double begin_s = 0.0;
  std::size_t next = 0;
  const auto add = [&](std::size_t index, double end_s) {
    if (index >= scenario.steps.size() || end_s <= begin_s) return;
    steps.push_back({begin_s, end_s, scenario.steps[index].title});
    begin_s = end_s;
    next = index + 1;
  };
  for (const CutEvent& event : recording.events) {
    if (event.subject < 0) continue;
    const auto step = static_cast<std::size_t>(event.subject);
    if (event.kind == CutEventKind::StepDone) add(step, second_from_tick(event.tick));
    if (event.kind != CutEventKind::StepReopened) continue;
    add(next, second_from_tick(event.tick));
    next = step;
  }
  add(next, duration_s);
  return steps;
}

std::vector<TimelineEvent> event_marks_of(const Texts& texts,
                                          const std::vector<AttemptEvent>& events) {
  std::vector<TimelineEvent> marks;
  marks.reserve(events.size());
  for (const AttemptEvent& event : events)
    marks.push_back({event.time_s, event.meaning, std::string(texts.text(event.words))});
  return marks;
}

std::vector<TimelineKey> legend_of(const Texts& texts, std::initializer_list<TimelineShape> more) {
  std::vector<TimelineKey> legend;
  const auto add = [&](TimelineShape shape) {
    const auto* const words = std::find_if(std::begin(shape_texts), std::end(shape_texts),
                                           [&](const auto& each) { return each.first == shape; });
    legend.push_back({shape, std::string(texts.text(words->second))});
  };
  for (const TimelineShape shape : {TimelineShape::Neutral, TimelineShape::Info,
                                    TimelineShape::Good, TimelineShape::Warn, TimelineShape::Bad})
    add(shape);
  for (const TimelineShape shape : more) add(shape);
  add(TimelineShape::Cluster);
  return legend;
}

double highest_of(const std::vector<ChartPoint>& points, double step) noexcept {
  double highest = step;
  for (const ChartPoint& point : points)
    if (std::isfinite(point.y)) highest = std::max(highest, point.y);
  return step * std::ceil(highest / step);
}

TimelineTrack force_track(const Texts& texts, std::vector<ChartPoint> newton) {
  TimelineTrack force;
  force.name = texts.text("replay.force");
  force.unit = texts.text("replay.force.unit");
  force.high = highest_of(newton, rounded_force_up_to);
  force.samples = std::move(newton);
  return force;
}

double duration_s_of(const Recording& recording) noexcept {
  if (recording.samples.empty()) return least_duration_s;
  return std::max(least_duration_s, second_from_tick(recording.samples.back().tick));
}

}  // namespace hallux::ui
