/// Points of a body's surface by which it meets others.
///
/// A sawn wall is flat, so that its outermost points alone decide how another flat wall lies on it;
/// skin is round, and is met anywhere. Hence as many points as there may be are first shared by the
/// walls, each spread as far apart as they go, and a part of them is left to the skin.
#pragma once

#include <cstddef>
#include <vector>

#include "simulator/cutting/pieces/cut_solid.h"

namespace hallux::simulator {

struct ContactPoints {
  std::vector<Vec3> points_mm;
  /// The mean of the walls' directions out of the solid, by their areas; zero where there are none,
  /// or where they cancel.
  Vec3 out_of_walls{0.0, 0.0, 0.0};
};

/// At most `most` corners of the mesh, three quarters of them of walls where there are any.
/// ensures the same on every machine
ContactPoints contact_points(const CutSolid& solid, std::size_t most);

/// The middle of the solid's volume.
/// needs   the mesh is closed
Vec3 centroid_of(const IndexedMesh& mesh);

}  // namespace hallux::simulator
