/// A loop of crossings with few corners. Inside this corner only.
#pragma once

#include <vector>

#include "simulator/cutting/field/outline_tile.h"

namespace hallux::simulator {

/// Appends the corners of a closed line that crosses the same grid edges in the same order, each
/// between `outer` and `inner`, in straight segments as long as they go.
/// needs   a loop as marching squares make it, the opened region on its left
/// ensures the first corner is the first crossing; at least three corners; linear in the number of
///         crossings
/// source  docs/cutting.md section 2
void append_straightened(const std::vector<Crossing>& loop, std::vector<Vec2>& corners_mm);

}  // namespace hallux::simulator
