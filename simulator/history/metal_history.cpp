#include "simulator/history/metal_history.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

bool is_of_metal(CutEventKind kind) noexcept {
  return kind == CutEventKind::BoreBegun || kind == CutEventKind::ImplantLeft;
}

class MetalFollower {
 public:
  MetalFollower(const Tray& tray, const FragmentPoses& lying)
      : poses_(lying), bores_(tray), implants_(tray) {}

  void apply(const CutEvent& event) {
    if (!poses_.apply(event)) return;
    if (bores_.apply(event, poses_)) note_bores(event.tick);
    if (implants_.apply(event, poses_)) note_implant(event);
  }
  void apply(const ToolSample& sample) {
    if (bores_.count() == 0) return;
    bores_.apply(sample, poses_);
    if (has(sample.status, ToolStatus::Boring) || has(sample.status, ToolStatus::DriveOn))
      note_bores(sample.tick);
  }
  MetalHistory finish() && { return std::move(made_); }

 private:
  void note_bores(std::int64_t tick) {
    const std::span<const BorePlace> places = bores_.places();
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i == made_.bores.size()) made_.bores.push_back({places[i], tick, {}});
      BoreGrowth& growth = made_.bores[i];
      growth.at_last = places[i];
      const double depth_mm = places[i].bore.depth_mm;
      if (growth.depths.empty() || depth_mm > growth.depths.back().depth_mm)
        growth.depths.push_back({tick, depth_mm});
    }
  }
  void note_implant(const CutEvent& event) {
    const bool is_set =
        event.kind == CutEventKind::ImplantLeft || event.kind == CutEventKind::ImplantCarried;
    if (!is_set && event.kind != CutEventKind::ImplantTaken) return;
    for (ImplantStay& stay : made_.implants) {
      if (stay.number == event.subject) stay.until_tick = std::min(stay.until_tick, event.tick);
    }
    if (is_set)
      made_.implants.push_back({event.subject, implants_[event.subject], event.tick, never_tick});
  }

  FragmentPoses poses_;
  BoreSet bores_;
  ImplantSet implants_;
  MetalHistory made_;
};

}  // namespace

double BoreGrowth::depth_mm_at(std::int64_t tick) const noexcept {
  const auto next =
      std::upper_bound(depths.begin(), depths.end(), tick,
                       [](std::int64_t wanted, const Depth& depth) { return wanted < depth.tick; });
  return next == depths.begin() ? 0.0 : std::prev(next)->depth_mm;
}

double BoreGrowth::opened_mm_at(std::int64_t tick) const noexcept {
  Bore bore = at_last.bore;
  bore.depth_mm = depth_mm_at(tick);
  const Segment axis = axis_of(capsule_of(bore));
  return length_of(axis.to - axis.from);
}

MetalHistory metal_history(const Recording& recording, const Tray& tray,
                           const FragmentPoses& lying) {
  const bool has_metal = std::any_of(recording.events.begin(), recording.events.end(),
                                     [](const CutEvent& each) { return is_of_metal(each.kind); });
  if (!has_metal) return {};
  MetalFollower follower(tray, lying);
  auto event = recording.events.begin();
  for (const ToolSample& sample : recording.samples) {
    for (; event != recording.events.end() && event->tick <= sample.tick; ++event)
      follower.apply(*event);
    follower.apply(sample);
  }
  for (; event != recording.events.end(); ++event) follower.apply(*event);
  return std::move(follower).finish();
}

}  // namespace hallux::simulator
