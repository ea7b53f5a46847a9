/// What an attempt did to the bone beside the cut, computed again from its samples as the step
/// computed it: heat, and how far the blade bent.
#pragma once

#include <cstddef>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/mesh/bones.h"
#include "simulator/record/record.h"
#include "simulator/step/tool_effects.h"
#include "simulator/tool/tray.h"

namespace hallux::assessment {

struct EffectTrack {
  /// Of the hottest bone at the end of each stretch [degrees Celsius].
  std::vector<double> hottest_celsius;
  /// Of the whole recording.
  simulator::HeatSummary heat;
  /// Of the blade along its normal, without sign.
  double greatest_deflection_mm = 0.0;
};

/// One entry for each `stretch` samples, the last perhaps for fewer. Bone that was picked up still
/// leads heat away here: a recording holds no bodies of pieces.
/// is_guided  a guide leads the hand (see simulator::SawInHand)
/// needs   recording's samples and events are in the order of their ticks; stretch > 0
/// errors  Cancelled
/// thread  any
EffectTrack track_effects(simulator::Bones bones, const simulator::Tray& tray, bool is_guided,
                          const simulator::Recording& recording, std::size_t stretch,
                          const Progress& progress = {});

}  // namespace hallux::assessment
