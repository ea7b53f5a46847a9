/// Mends of a solid that was cut: what a half-edge mesh, or any reader of the solid, would stumble
/// over. Inside this corner only.
#pragma once

#include <cstdint>

#include "simulator/cutting/pieces/cut_solid.h"

namespace hallux::simulator {

/// Triangles without area can name the same pair of points twice; half-edge meshes refuse that.
/// Each such edge gets a point of its own in its middle, until no pair is repeated.
/// needs   the solid is closed as a chain; pairs are repeated only among the triangles from
///         `first_triangle` on, and none of them names a point twice
void separate_repeated_edges(CutSolid& solid, std::uint32_t first_triangle);
/// Leaves out the points that no triangle uses; the others keep their order.
void drop_unused_points(IndexedMesh& mesh);

}  // namespace hallux::simulator
