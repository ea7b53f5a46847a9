#include "tests/ui/sight/recorded_moments.h"

#include "simulator/cutting/field/kerf_set.h"

namespace hallux::ui {

std::vector<WorkMoment> moments_of(const simulator::Recording& recording,
                                   const simulator::Blade& blade,
                                   const RigidTransform& world_from_bone,
                                   std::int64_t every_ticks) {
  simulator::KerfSet kerfs(blade, world_from_bone,
                           {.spacing_mm = 0.2, .u_count = 401, .v_count = 401});
  std::vector<WorkMoment> moments;
  std::size_t next_event = 0;
  std::int32_t kerf = -1;
  for (const simulator::ToolSample& sample : recording.samples) {
    while (next_event < recording.events.size() &&
           recording.events[next_event].tick <= sample.tick) {
      const simulator::CutEvent& event = recording.events[next_event++];
      if (event.kind == simulator::CutEventKind::PlaneFrozen) kerfs.freeze(event.pose);
    }
    kerfs.apply(sample);
    if (sample.kerf >= 0) kerf = sample.kerf;
    if (sample.tick % every_ticks != 0 || !has(sample.status, simulator::ToolStatus::SawOn))
      continue;
    WorkMoment moment;
    moment.world_from_tool = simulator::transform_from(sample.world_from_tool);
    if (kerf >= 0) {
      moment.kerf = opening_of(kerfs.plane(kerf), kerfs.field(kerf));
    } else {
      moment.kerf.plane = {inverse(world_from_bone) * moment.world_from_tool, blade.kerf_mm};
    }
    moments.push_back(moment);
  }
  return moments;
}

}  // namespace hallux::ui
