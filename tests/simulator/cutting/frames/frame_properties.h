/// What holds in every frame of every bone, beyond that it is closed and in balance.
#pragma once

#include "tests/simulator/cutting/frames/kerf_play.h"

namespace hallux::tests {

/// The kerf's walls lie on its two planes, to 1e-9 mm.
bool has_walls_on_planes(const PlayedFrame& frame);
/// No point of the patch stands in the open kerf, more than the lattice's steps from its border.
bool has_empty_kerf(const PlayedFrame& frame);
/// Each triangle of the skin lies on a hidden one and faces as it does, if it is wide enough to
/// have a slope when its corners are a lattice step off.
bool keeps_skin(const PlayedFrame& frame);
/// Each new point of the skin lies on its parent: the parent's corners, weighted, give its place.
bool interpolates_skin(const PlayedFrame& frame);

}  // namespace hallux::tests
