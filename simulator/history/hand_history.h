/// What was in the hand over the time of a recording: tools of the tray, and pieces in forceps.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/history/bone_at_tick.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

/// A piece in the forceps.
struct Grip {
  std::int32_t fragment = 0;
  std::int64_t from_tick = 0, until_tick = never_tick;
  /// Of the tool in the world, in the sample before.
  RigidTransform world_from_tool;
};

struct HandHistory {
  struct Choice {
    std::int64_t tick = 0;
    /// On the tray.
    std::int32_t tool = 0;
  };
  /// By time; before the first it is the tray's first.
  std::vector<Choice> choices;
  /// By time.
  std::vector<Grip> grips;

  /// Its place on the tray, forceps or not.
  std::int32_t tool_at(std::int64_t tick) const noexcept;
  /// Null while nothing is gripped.
  const Grip* grip_at(std::int64_t tick) const noexcept;
};

HandHistory hand_history(const Recording& recording);

}  // namespace hallux::simulator
