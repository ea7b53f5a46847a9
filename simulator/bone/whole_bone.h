/// A bone that was never cut, or a fragment as it came to be, with the tree over it: made once,
/// borrowed by all who cut it.
#pragma once

#include <utility>

#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

/// Never changes; stays where it was made.
struct WholeBone {
  /// needs   the mesh is closed
  /// thread  any; work of 0.1 s
  explicit WholeBone(IndexedMesh mesh) : WholeBone(uncut_solid(std::move(mesh))) {}
  /// The walls that kerfs left before keep their sources.
  explicit WholeBone(CutSolid fragment) : solid(std::move(fragment)), tree(solid.mesh) {}
  WholeBone(const WholeBone&) = delete;
  WholeBone& operator=(const WholeBone&) = delete;

  const CutSolid solid;
  const Bvh tree;
};

}  // namespace hallux::simulator
