/// A bone that was never cut, with the tree over it: made once, borrowed by all who cut that bone.
#pragma once

#include <utility>

#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

/// Never changes; stays where it was made.
struct WholeBone {
  /// needs   the mesh is closed
  /// thread  any; work of 0.1 s
  explicit WholeBone(IndexedMesh mesh) : solid(uncut_solid(std::move(mesh))), tree(solid.mesh) {}
  WholeBone(const WholeBone&) = delete;
  WholeBone& operator=(const WholeBone&) = delete;

  const CutSolid solid;
  const Bvh tree;
};

}  // namespace hallux::simulator
