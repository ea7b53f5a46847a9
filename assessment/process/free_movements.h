/// How smooth the hand's movements through air were. Inside this room only.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "assessment/process/finding.h"
#include "assessment/process/handle_track.h"

namespace hallux::assessment {

/// The smoothness of each free movement that has one, in the order of time; the bound is of where
/// the movement begins and ends, each within a tick.
struct FreeMovements {
  std::vector<Finding> arcs, jerks;
};

/// A free movement is a longest run of ticks in which neither a tooth touched bone nor a kerf held
/// the blade and the handle moved with 5 mm/s or more, of at least 0.3 s.
FreeMovements free_movements(std::span<const HandleStretch> stretches);

/// The medians over all free movements; their moment is the least smooth one. Nothing below three
/// movements.
struct Smoothness {
  std::optional<Finding> sparc;
  std::optional<Finding> ldlj;
};

/// coarse   of the same recording at twice the step (see handle_stretches), which bounds the values
/// ensures  without `coarse` the bounds are of the movements' ends alone
Smoothness measure_smoothness(const FreeMovements& movements, const FreeMovements& coarse = {});

}  // namespace hallux::assessment
