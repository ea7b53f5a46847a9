/// What an attempt left behind: its bodies and how they lie, its wires and screws, the steps that
/// were done.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assessment/fixation/what_is_left.h"

namespace hallux::ui {

struct LeftBehind : assessment::WhatIsLeft {
  assessment::RebuiltBone rebuilt;
  /// Of each step of the scenario, when it was declared done last; nothing: it was not, or taken up
  /// again.
  std::vector<std::optional<std::int64_t>> done_ticks;
};

/// Whether a wedge was closed whose halves are bodies, but one solid for the score.
bool has_undivided_hinge(const scenarios::Plan& plan,
                         const simulator::Recording& recording) noexcept;

/// Computed from the recording: nothing of what a score keeps.
/// plan    the scenario's on these bones
/// scored  the bone as it was rebuilt for its score: serves where closed wedges are divided in it
/// errors  Cancelled
/// thread  any
LeftBehind left_behind(const scenarios::Scenario& scenario, const scenarios::Plan& plan,
                       const simulator::Bones& bones, const simulator::Recording& recording,
                       assessment::RebuiltBone scored, const Progress& progress = {});

}  // namespace hallux::ui
