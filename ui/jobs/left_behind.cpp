#include "ui/jobs/left_behind.h"

#include <algorithm>
#include <utility>

#include "scenarios/tray/laid_out_tools.h"

namespace hallux::ui {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;

/// Of the whole work; the rest is to find how bodies lie.
constexpr double rebuilt_share = 0.7;

std::vector<std::optional<std::int64_t>> done_ticks_of(const scenarios::Scenario& scenario,
                                                       const simulator::Recording& recording) {
  std::vector<std::optional<std::int64_t>> done(scenario.steps.size());
  for (const CutEvent& event : recording.events) {
    const bool is_step =
        event.subject >= 0 && static_cast<std::size_t>(event.subject) < done.size();
    if (!is_step) continue;
    auto& tick = done[static_cast<std::size_t>(event.subject)];
    if (event.kind == CutEventKind::StepDone) tick = event.tick;
    if (event.kind == CutEventKind::StepReopened) tick.reset();
  }
  return done;
}

}  // namespace

bool has_undivided_hinge(const scenarios::Plan& plan,
                         const simulator::Recording& recording) noexcept {
  if (assessment::hinges_of(plan).are_always_divided) return false;
  return std::ranges::any_of(recording.events, [](const CutEvent& event) {
    return event.kind == CutEventKind::HingeClosed;
  });
}

LeftBehind left_behind(const scenarios::Scenario& scenario, const scenarios::Plan& plan,
                       const simulator::Bones& bones, const simulator::Recording& recording,
                       assessment::RebuiltBone scored, const Progress& progress) {
  if (has_undivided_hinge(plan, recording)) {
    scored = assessment::rebuild(bones, scenarios::tray_of(scenario), recording,
                                 part_of(progress, 0.0, rebuilt_share), nullptr, {},
                                 {scenarios::planned_bridges(plan), true});
  }
  LeftBehind left{assessment::what_is_left(recording, scored, bones, plan), std::move(scored),
                  done_ticks_of(scenario, recording)};
  report(progress, 1.0);
  return left;
}

}  // namespace hallux::ui
