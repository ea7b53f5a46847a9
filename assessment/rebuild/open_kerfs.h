/// A recording's kerfs, opened again in the order in which the step opened them.
#pragma once

#include <cstdint>

#include "simulator/cutting/kerf_set.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// Calls `frozen(tick)` after each plane that begins a kerf, and `swept(index)` after each sample, with `kerfs` as they stood
/// then. A plane that was refused begins none.
/// needs   samples and events are in the order of their ticks
template <typename Frozen, typename Swept>
void open_kerfs(simulator::KerfSet& kerfs, const simulator::Recording& recording, Frozen&& frozen,
                Swept&& swept) {
  auto event = recording.events.begin();
  for (std::size_t index = 0; index < recording.samples.size(); ++index) {
    const simulator::ToolSample& sample = recording.samples[index];
    for (; event != recording.events.end() && event->tick <= sample.tick; ++event) {
      if (event->kind != simulator::CutEventKind::PlaneFrozen) continue;
      if (kerfs.freeze(event->pose) >= 0) frozen(event->tick);
    }
    kerfs.follow(sample);
    swept(index);
  }
}

}  // namespace hallux::assessment
