#include "simulator/history/bone_at_tick.h"

#include <algorithm>
#include <utility>

namespace hallux::simulator {

std::size_t KerfGrowth::grown_at(std::int64_t tick) const noexcept {
  const auto next = std::upper_bound(ticks.begin(), ticks.end(), tick);
  return static_cast<std::size_t>(next - ticks.begin());
}

std::vector<KerfGrowth> growths_of(std::vector<OpenedField> opened, const Recording& recording) {
  std::vector<KerfGrowth> growths;
  for (OpenedField& field : opened) {
    std::vector<std::int32_t> ticks = field.ticks();
    growths.push_back({std::move(field), std::move(ticks)});
  }
  for (const CutEvent& event : recording.events) {
    if (event.kind != CutEventKind::PlaneFrozen || event.subject < 0) continue;
    const auto kerf = static_cast<std::size_t>(event.subject);
    if (kerf >= growths.size()) continue;
    growths[kerf].fragment = static_cast<std::int32_t>(event.value);
    growths[kerf].frozen_tick = event.tick;
  }
  return growths;
}

BoneAtTick::BoneAtTick(const WholeBone& whole, NumberedPieces pieces,
                       const std::vector<KerfGrowth>& growths, std::vector<std::int32_t> kerfs)
    : growths_(&growths),
      kerfs_(std::move(kerfs)),
      bone_(whole, std::move(pieces)),
      grown_(kerfs_.size(), 0) {
  for (std::size_t place = 0; place < kerfs_.size(); ++place) put(place, {});
}

CutBone& BoneAtTick::move_to(std::int64_t tick) {
  for (std::size_t place = 0; place < kerfs_.size(); ++place) {
    const std::size_t grown = growth(place).grown_at(tick);
    if (grown_[place] == grown) continue;
    grown_[place] = grown;
    put(place, grown == 0 ? RegionOutline{} : outline_at(growth(place).opened, tick));
  }
  return bone_;
}

CutSolid BoneAtTick::all_but(std::int32_t kerf, std::int64_t tick) {
  const auto found = std::find(kerfs_.begin(), kerfs_.end(), kerf);
  return move_to(tick).all_but(
      found == kerfs_.end() ? -1 : static_cast<std::int32_t>(found - kerfs_.begin()));
}

void BoneAtTick::put(std::size_t place, RegionOutline region) {
  const OpenedField& opened = growth(place).opened;
  bone_.put_kerf(static_cast<std::int32_t>(place),
                 {kerfs_[place], opened.plane, opened.grid, std::move(region)});
}

}  // namespace hallux::simulator
