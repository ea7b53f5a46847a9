/// Bores, wires and screws of a recording over its time, by the rules of BoreSet and ImplantSet.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/cutting/hole/bore_set.h"
#include "simulator/cutting/hole/implant_set.h"
#include "simulator/history/bone_at_tick.h"

namespace hallux::simulator {

/// A bore in one of the fragments that it goes through.
struct BoreGrowth {
  /// A place of the bore set, as it was at last.
  BorePlace at_last;
  /// When the bore was begun, or its fragment was parted.
  std::int64_t from_tick = 0;
  struct Depth {
    std::int64_t tick = 0;
    double depth_mm = 0.0;
  };
  /// By time, each deeper than the one before.
  std::vector<Depth> depths;

  /// 0 before it was begun.
  double depth_mm_at(std::int64_t tick) const noexcept;
  /// How much of its axis is open then, as its capsule says.
  double opened_mm_at(std::int64_t tick) const noexcept;
};

/// A wire or screw while it goes along with one fragment.
struct ImplantStay {
  /// By ImplantLeft, counted from 0.
  std::int32_t number = 0;
  Implant implant;
  std::int64_t from_tick = 0, until_tick = never_tick;

  bool is_there(std::int64_t tick) const noexcept { return tick >= from_tick && tick < until_tick; }
};

struct MetalHistory {
  /// By their places in the bore set.
  std::vector<BoreGrowth> bores;
  /// By time.
  std::vector<ImplantStay> implants;
};

/// lying   the bones' fragments before anything is moved
/// ensures events that name what there is not are passed over
MetalHistory metal_history(const Recording& recording, const Tray& tray,
                           const FragmentPoses& lying);

}  // namespace hallux::simulator
