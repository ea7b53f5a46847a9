/// The rims at which a hole's cylinder meets a bone's skin, as closed lines on the skin: for
/// drawing.
#pragma once

#include <vector>

#include "simulator/cutting/hole/capsule.h"
#include "simulator/mesh/bvh.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

struct HoleRim {
  /// Each on the skin and on the cylinder, at least three; the last joins the first.
  std::vector<Vec3> points_mm;
  /// Mean way of its points along the axis, from the hole's beginning.
  double way_mm = 0.0;
};

/// The rims whose mean way lies between one radius before the beginning and the end of the hole, in
/// order of it; none where the cylinder does not meet the skin, or only grazes an edge over less
/// than a step. A slanting entry has one, longer rim; a hole along an edge of the bone may have one
/// that runs down its side.
/// shape   `tree` is that of `skin`, closed; steps of at most a 48th of a turn
/// ensures each point that lies on an edge of the mesh is the same for both its triangles
/// thread  any but haptic: fills vectors
std::vector<HoleRim> hole_rims(const IndexedMesh& skin, const Bvh& tree, const Capsule& hole);

}  // namespace hallux::simulator
