/// Points of a body's surface by which it meets others.
///
/// A sawn wall is flat, so that how another flat wall lies on it is decided where the two end: at
/// their rims, and not only at tips, for a piece that was moved lies on a part of a wall. Skin is
/// round, and is met anywhere. Hence tips come first, then as many points as there may be are
/// spread over all rims, and a part of them is left to the skin.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

/// At most `most` corners of the mesh, three quarters of them of rims where there are any. The
/// first quarter is spread over all of it, and what follows lies in between.
/// ensures the same on every machine
std::vector<Vec3> contact_points(const CutSolid& solid, std::size_t most);

/// The mean of the directions out of the solid, by their areas, of those walls that still face what
/// they came from: others lie no more than 1.5 mm ahead, where all was cut. Zero where none does,
/// or where they cancel.
Vec3 out_of_facing_walls(const CutSolid& solid, std::span<const Bvh* const> others);

/// The middle of the solid's volume.
/// needs   the mesh is closed
Vec3 centroid_of(const IndexedMesh& mesh);

}  // namespace hallux::simulator
