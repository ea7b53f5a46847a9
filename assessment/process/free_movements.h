/// How smooth the hand's movements through air were. Inside this room only.
#pragma once

#include <optional>
#include <span>

#include "assessment/process/finding.h"
#include "assessment/process/handle_track.h"

namespace hallux::assessment {

/// The medians over all free movements; their moment is the least smooth one. Nothing below three
/// movements.
struct Smoothness {
  std::optional<Finding> sparc;
  std::optional<Finding> ldlj;
};

/// A free movement is a longest run of ticks in which neither a tooth touched bone nor a kerf held
/// the blade and the handle moved with 5 mm/s or more, of at least 0.3 s.
/// coarse   the same recording at twice the step (see handle_stretches), which bounds the values
/// ensures  without `coarse` the bounds are of the movements' ends alone
Smoothness measure_smoothness(std::span<const HandleStretch> stretches,
                              std::span<const HandleStretch> coarse = {});

}  // namespace hallux::assessment
