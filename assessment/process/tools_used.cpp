#include "assessment/process/tools_used.h"

#include <algorithm>

namespace hallux::assessment {

const simulator::Blade& blade_of_kerf(const simulator::Recording& recording,
                                      const RebuiltBone& rebuilt, std::int32_t kerf) {
  const simulator::Tray& tray = rebuilt.fields.tray();
  std::int32_t saw = 0, frozen = 0;
  for (const simulator::CutEvent& event : recording.events) {
    if (event.kind == simulator::CutEventKind::ToolChosen && tray.saw(event.subject) != nullptr)
      saw = event.subject;
    if (event.kind == simulator::CutEventKind::PlaneFrozen && frozen++ == kerf) break;
  }
  return tray.saw(saw)->blade;
}

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
