#include "ui/screens/replay/replay_timeline.h"

namespace hallux::ui {

namespace {

constexpr float two_tracks_from = 800.0F, one_track_from = 620.0F, legend_from = 860.0F,
                compact_below = 440.0F;
/// Without a line of remarks the lines stand closer, and there is room for the force.
constexpr float one_close_track_from = 460.0F;
constexpr double force_step_newton = 5.0, plan_step_mm = 2.0;

std::vector<TimelineNote> marks_of(const Remarks& remarks) {
  std::vector<TimelineNote> marks;
  for (const Remark& remark : remarks.order) {
    const double time_s = second_of(remark);
    if (const database::Note* note = remarks.note(remark)) {
      marks.push_back({time_s, std::to_string(remark.number), note->text, TimelineShape::Note});
    } else {
      const database::HelpRequest& question = *remarks.question(remark);
      marks.push_back({time_s,
                       {},
                       question.question,
                       question.answer ? TimelineShape::Answered : TimelineShape::Question});
    }
  }
  return marks;
}

}  // namespace

bool ReplayTimeline::shows_legend(float display_height) const noexcept {
  return state_.shows_legend.value_or(display_height >= legend_from);
}

const Curves& ReplayTimeline::curves(const ReplayMaterial& material) {
  if (!state_.range) return material.curves;
  if (range_ != state_.range) {
    range_ = state_.range;
    curves_ = curves_of(material, *range_);
  }
  return curves_;
}

Timeline ReplayTimeline::shown(const Texts& texts, const ReplayMaterial& material,
                               const Remarks* remarks, double now_s, float display_height) {
  Timeline shown{.duration_s = material.duration_s,
                 .range = state_.range,
                 .now_s = now_s,
                 .steps_name = std::string(texts.text("replay.steps")),
                 .events_name = std::string(texts.text("replay.events")),
                 .steps = material.steps,
                 .events = event_marks_of(texts, material.events)};
  if (remarks != nullptr) {
    shown.notes_name = texts.text("notes.title");
    shown.notes = marks_of(*remarks);
    shown.legend =
        legend_of(texts, {TimelineShape::Note, TimelineShape::Question, TimelineShape::Answered});
  } else {
    shown.legend = legend_of(texts, {});
  }
  const bool has_close_track = remarks == nullptr && display_height >= one_close_track_from &&
                               display_height < one_track_from;
  shown.is_compact = display_height < compact_below || has_close_track;
  // The scale is that of all of it, so that a force looks the same however near one is.
  if (display_height >= one_track_from || has_close_track) {
    TimelineTrack force = force_track(texts, curves(material).force_newton);
    force.high = highest_of(material.curves.force_newton, force_step_newton);
    shown.tracks.push_back(std::move(force));
  }
  if (display_height >= two_tracks_from) {
    TimelineTrack plan{.name = std::string(texts.text("replay.to_plan")),
                       .unit = std::string(texts.text("replay.to_plan.unit")),
                       .samples = curves(material).to_plan_mm};
    plan.high = highest_of(material.curves.to_plan_mm, plan_step_mm);
    shown.tracks.push_back(std::move(plan));
  }
  return shown;
}

}  // namespace hallux::ui
