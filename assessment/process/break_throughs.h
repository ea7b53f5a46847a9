/// What the blade did as its teeth left bone at the far side. Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "assessment/process/finding.h"
#include "simulator/base/vector.h"
#include "simulator/record/record.h"
#include "simulator/tool/saw.h"

namespace hallux::assessment {

/// The worst of the break-throughs asked about.
struct BreakThroughs {
  /// How far the furthest tooth went beyond the far surface within 200 ms: along the feed, from
  /// where the teeth stood as the last of them left bone. 0 without a break-through. Its moment
  /// runs from the break-through to there.
  Finding plunge_mm;
  /// That tooth.
  Vec3 plunge_in_bone_mm{0.0, 0.0, 0.0};
  /// The mean force on the hand in the 20 ms before; nothing without a break-through.
  std::optional<Finding> force_newton;
  /// The mean speed along the feed in the 50 ms after; nothing without a break-through. 0 where the
  /// blade was drawn back.
  std::optional<Finding> speed_mm_s;
};

struct BreakThroughWorld {
  const simulator::Recording& recording;
  const simulator::Blade& blade;
  RigidTransform bone_from_world;
};

/// Of the break-throughs in these kerfs.
/// needs   samples and events are in the order of their ticks
BreakThroughs measure_break_throughs(const BreakThroughWorld& world,
                                     std::span<const std::int32_t> kerfs);

}  // namespace hallux::assessment
