/// A bone's outer surface as a plan asks for it. Inside this corner only.
#pragma once

#include <optional>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::scenarios {

/// Where the ray meets the mesh for the last time [mm, the mesh's frame]; nothing where it misses.
/// needs   direction has length 1
std::optional<Vec3> last_on_ray(const simulator::IndexedMesh& mesh, const Vec3& from_mm,
                                const Vec3& direction);

}  // namespace hallux::scenarios
