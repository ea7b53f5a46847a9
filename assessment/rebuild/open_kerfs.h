/// A recording's kerfs, opened again in the order in which the step opened them.
/// Inside this room only.
#pragma once

#include <cstdint>

#include "simulator/cutting/field/kerf_set.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// Freezes the planes and places the fragments alone. Calls `frozen(tick)` after each that begins a
/// kerf, and `sampled(index)` for each sample when its turn comes. A plane that was refused begins
/// none.
/// needs   samples and events are in the order of their ticks
template <typename Frozen, typename Sampled>
void freeze_kerfs(simulator::KerfSet& kerfs, const simulator::Recording& recording, Frozen&& frozen,
                  Sampled&& sampled) {
  auto event = recording.events.begin();
  for (std::size_t index = 0; index < recording.samples.size(); ++index) {
    for (; event != recording.events.end() && event->tick <= recording.samples[index].tick;
         ++event) {
      const bool is_done = kerfs.apply(*event);
      if (is_done && event->kind == simulator::CutEventKind::PlaneFrozen) frozen(event->tick);
    }
    sampled(index);
  }
}

/// The same, and opens them: `swept(index, risen)` is called after each sample, with `kerfs` as
/// they stood then and those that the sample raised.
template <typename Frozen, typename Swept>
void open_kerfs(simulator::KerfSet& kerfs, const simulator::Recording& recording, Frozen&& frozen,
                Swept&& swept) {
  freeze_kerfs(kerfs, recording, frozen,
               [&](std::size_t index) { swept(index, kerfs.apply(recording.samples[index])); });
}

}  // namespace hallux::assessment
