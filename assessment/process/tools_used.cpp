#include "assessment/process/tools_used.h"

#include <algorithm>

namespace hallux::assessment {

std::optional<std::int64_t> first_cut_with_another(const simulator::Recording& recording,
                                                   std::span<const std::int32_t> kerfs,
                                                   std::int32_t place) {
  std::int32_t in_hand = 0;
  auto event = recording.events.begin();
  for (const simulator::ToolSample& sample : recording.samples) {
    for (; event != recording.events.end() && event->tick <= sample.tick; ++event) {
      if (event->kind == simulator::CutEventKind::ToolChosen) in_hand = event->subject;
    }
    const bool is_of_cut = std::ranges::find(kerfs, sample.kerf) != kerfs.end();
    if (is_of_cut && in_hand != place && has(sample.status, simulator::ToolStatus::Cutting))
      return sample.tick;
  }
  return std::nullopt;
}

}  // namespace hallux::assessment
