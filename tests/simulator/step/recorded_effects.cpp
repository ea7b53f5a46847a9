#include "tests/simulator/step/recorded_effects.h"

namespace hallux::tests {

using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::ToolSample;

RecordedEffects::RecordedEffects(const simulator::Bone& bone, const simulator::Recording& recording,
                                 const std::vector<simulator::DangerCapsule>& danger_zones,
                                 bool is_guided)
    : tissue_(bone),
      kerfs_(simulator::Blade{}, bone.world_from_bone),
      effects_(bone.world_from_bone, {.is_guided = is_guided}, danger_zones) {
  auto next = recording.events.begin();
  for (const ToolSample& sample : recording.samples) {
    for (; next != recording.events.end() && next->tick <= sample.tick; ++next) {
      if (next->kind == CutEventKind::PlaneFrozen) kerfs_.freeze(next->pose);
    }
    kerfs_.apply(sample);
    effects_.apply(sample, {tissue_, kerfs_, {}});
    for (CutEvent event; effects_.take_event(kerfs_, event);) events_.push_back(event);
  }
}

std::vector<CutEvent> RecordedEffects::events(CutEventKind kind) const {
  std::vector<CutEvent> found;
  for (const CutEvent& event : events_) {
    if (event.kind == kind) found.push_back(event);
  }
  return found;
}

}  // namespace hallux::tests
