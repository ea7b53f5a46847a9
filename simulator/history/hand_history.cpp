#include "simulator/history/hand_history.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

RigidTransform tool_before(const std::vector<ToolSample>& samples, std::int64_t tick) {
  const auto next = std::partition_point(samples.begin(), samples.end(),
                                         [tick](const auto& each) { return each.tick < tick; });
  return next == samples.begin() ? RigidTransform{}
                                 : transform_from(std::prev(next)->world_from_tool);
}

}  // namespace

std::int32_t HandHistory::tool_at(std::int64_t tick) const noexcept {
  const auto next = std::upper_bound(
      choices.begin(), choices.end(), tick,
      [](std::int64_t wanted, const Choice& choice) { return wanted < choice.tick; });
  return next == choices.begin() ? 0 : std::prev(next)->tool;
}

const Grip* HandHistory::grip_at(std::int64_t tick) const noexcept {
  const auto next = std::upper_bound(
      grips.begin(), grips.end(), tick,
      [](std::int64_t wanted, const Grip& grip) { return wanted < grip.from_tick; });
  if (next == grips.begin()) return nullptr;
  const Grip& grip = *std::prev(next);
  return tick < grip.until_tick ? &grip : nullptr;
}

HandHistory hand_history(const Recording& recording) {
  HandHistory hand;
  for (const CutEvent& event : recording.events) {
    if (event.kind == CutEventKind::ToolChosen) hand.choices.push_back({event.tick, event.subject});
    if (event.kind == CutEventKind::Gripped) {
      hand.grips.push_back(
          {event.subject, event.tick, never_tick, tool_before(recording.samples, event.tick)});
    }
    if (event.kind == CutEventKind::Released && !hand.grips.empty())
      hand.grips.back().until_tick = event.tick;
  }
  return hand;
}

}  // namespace hallux::simulator
