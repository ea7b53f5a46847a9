#include "tests/simulator/step/wound_follower.h"

namespace hallux::tests {

using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::ToolSample;

WoundFollower::WoundFollower(const simulator::Bone& bone, const simulator::Recording& recording,
                             const simulator::WoundSettings& settings, bool is_guided)
    : tissue_(bone),
      kerfs_(simulator::BladeSize{}, bone.world_from_bone),
      wound_(bone.world_from_bone, {},
             {.cycles_per_minute = simulator::ContactSettings{}.cycles_per_minute,
              .is_guided = is_guided},
             settings) {
  auto next = recording.events.begin();
  for (const ToolSample& sample : recording.samples) {
    for (; next != recording.events.end() && next->tick <= sample.tick; ++next) {
      if (next->kind == CutEventKind::PlaneFrozen) kerfs_.freeze(next->pose);
    }
    kerfs_.follow(sample);
    wound_.follow(sample, {tissue_, kerfs_, {}});
    for (CutEvent event; wound_.take_event(kerfs_, event);) events_.push_back(event);
  }
}

std::vector<CutEvent> WoundFollower::events(CutEventKind kind) const {
  std::vector<CutEvent> found;
  for (const CutEvent& event : events_) {
    if (event.kind == kind) found.push_back(event);
  }
  return found;
}

}  // namespace hallux::tests
