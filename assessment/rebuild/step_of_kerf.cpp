#include "assessment/rebuild/step_of_kerf.h"

#include <algorithm>
#include <cstdint>

namespace hallux::assessment {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::ToolSample;

/// One in so many of a kerf's cutting samples may be a false start.
constexpr std::int64_t false_start_share = 10;

struct CutStep {
  std::int32_t step = 0;
  std::size_t cut = 0;
};

std::vector<CutStep> cut_steps_of(const scenarios::Plan& plan, const StepEvidence& evidence) {
  std::vector<CutStep> steps;
  for (std::size_t i = 0; i < evidence.steps.size(); ++i) {
    const scenarios::OperationStep& step = evidence.steps[i];
    if (!is_sawn(step)) continue;
    steps.push_back({static_cast<std::int32_t>(i), index_of_cut(plan, step.cut)});
  }
  return steps;
}

/// Per kerf, when it was sawn for good; when its plane was frozen, where it never cut.
std::vector<std::int64_t> sawn_ticks(const RebuiltBone& rebuilt,
                                     const simulator::Recording& recording) {
  std::vector<std::int64_t> ticks;
  for (const RebuiltKerf& kerf : rebuilt.kerfs) ticks.push_back(kerf.frozen_tick);
  std::vector<std::int64_t> samples(ticks.size(), 0);
  for (const ToolSample& sample : recording.samples) {
    const auto kerf = static_cast<std::size_t>(sample.kerf);
    if (sample.kerf < 0 || kerf >= ticks.size()) continue;
    if (!has(sample.status, simulator::ToolStatus::Cutting)) continue;
    const std::int64_t before = false_start_share * samples[kerf]++;
    if (before < rebuilt.kerfs[kerf].cutting_samples) ticks[kerf] = sample.tick;
  }
  return ticks;
}

/// Which cut steps are done and which was taken up again, as the events come.
class StepsDone {
 public:
  explicit StepsDone(const std::vector<CutStep>& steps)
      : steps_(steps), is_done_(steps.size(), 0), reopened_(steps.size()) {}

  /// Of the cut step that the event is about; the number of steps where it is about another.
  std::size_t index_of(const CutEvent& event) const noexcept {
    const auto found = std::ranges::find(steps_, event.subject, &CutStep::step);
    return static_cast<std::size_t>(found - steps_.begin());
  }

  void apply(const CutEvent& event) noexcept {
    const std::size_t index = index_of(event);
    if (index == steps_.size()) return;
    if (event.kind == CutEventKind::StepReopened) {
      is_done_[index] = 0;
      reopened_ = index;
    }
    if (event.kind != CutEventKind::StepDone) return;
    is_done_[index] = 1;
    if (reopened_ == index) reopened_ = steps_.size();
  }

  /// The cut at hand before these events.
  std::optional<std::size_t> cut_before(std::span<const CutEvent> later) const noexcept {
    if (reopened_ < steps_.size()) return steps_[reopened_].cut;
    for (const CutEvent& event : later) {
      const std::size_t index = index_of(event);
      const bool is_open = index < steps_.size() && is_done_[index] == 0;
      if (event.kind == CutEventKind::StepDone && is_open) return steps_[index].cut;
    }
    for (std::size_t index = 0; index < steps_.size(); ++index) {
      if (is_done_[index] == 0) return steps_[index].cut;
    }
    return std::nullopt;
  }

 private:
  const std::vector<CutStep>& steps_;
  std::vector<std::uint8_t> is_done_;
  /// The number of steps: none.
  std::size_t reopened_;
};

/// An event of a tick acts before its sample.
std::optional<std::size_t> cut_at(std::int64_t tick, const std::vector<CutStep>& steps,
                                  std::span<const CutEvent> events) {
  StepsDone done(steps);
  std::size_t next = 0;
  while (next < events.size() && events[next].tick <= tick) done.apply(events[next++]);
  return done.cut_before(events.subspan(next));
}

bool says_done(const std::vector<CutStep>& steps, std::span<const CutEvent> events) {
  return std::ranges::any_of(events, [&](const CutEvent& event) {
    return event.kind == CutEventKind::StepDone &&
           std::ranges::find(steps, event.subject, &CutStep::step) != steps.end();
  });
}

}  // namespace

std::vector<std::optional<std::size_t>> cuts_at_hand(const RebuiltBone& rebuilt,
                                                     const scenarios::Plan& plan,
                                                     const StepEvidence& evidence) {
  std::vector<std::optional<std::size_t>> cuts(rebuilt.kerfs.size());
  const std::vector<CutStep> steps = cut_steps_of(plan, evidence);
  const std::span<const CutEvent> events = evidence.recording.events;
  if (!says_done(steps, events)) return cuts;
  const std::vector<std::int64_t> ticks = sawn_ticks(rebuilt, evidence.recording);
  for (std::size_t kerf = 0; kerf < cuts.size(); ++kerf) {
    cuts[kerf] = cut_at(ticks[kerf], steps, events);
  }
  return cuts;
}

}  // namespace hallux::assessment
