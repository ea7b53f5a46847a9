/// Lays one surface on another by rigid motions, for comparing a generated bone with a real one.
#pragma once

#include <vector>

#include "simulator/base/transform.h"
#include "simulator/mesh/bvh.h"

namespace hallux::scenarios_test {

/// Points spread evenly over the area of a mesh; the same points for the same mesh.
std::vector<Vec3> area_samples(const simulator::IndexedMesh& mesh, std::size_t count);

/// The rigid motion that lays `points_mm` on the surface of `target`: principal axes with every
/// sign, then closest points again and again; the best of all starts.
/// needs   target_points_mm are spread over the target's surface
RigidTransform fit_rigidly(const std::vector<Vec3>& points_mm, const simulator::Bvh& target,
                           const std::vector<Vec3>& target_points_mm);

/// Closest points again and again from a start that is near already.
RigidTransform refine_fit(const std::vector<Vec3>& points_mm, const simulator::Bvh& target,
                          RigidTransform target_from_points, int rounds);

}  // namespace hallux::scenarios_test
