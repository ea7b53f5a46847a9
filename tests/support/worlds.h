/// Closed, outward meshes with volumes that can be computed by hand: the worlds of the tests.
///
/// All are centred on the origin, with their edges along the axes [mm], and the same bits each
/// time.
#pragma once

#include <cstddef>

#include "simulator/base/transform.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::tests {

/// A box of 12 triangles.
simulator::IndexedMesh solid_block(const Vec3& size_mm);

/// Two boxes of this size side by side along x with `gap_mm` between them, as one mesh of two
/// shells.
simulator::IndexedMesh two_blocks(const Vec3& size_mm, double gap_mm);

/// A U lying in the xy plane, open towards +y: two arms and a floor of thickness `wall_mm`,
/// extruded over size_mm.z.
/// needs   2 * wall_mm < size_mm.x, wall_mm < size_mm.y
simulator::IndexedMesh u_shape(const Vec3& size_mm, double wall_mm);

struct Tube {
  double outer_radius_mm = 8.0;
  /// 0: no canal.
  double inner_radius_mm = 5.0;
  /// Along x.
  double length_mm = 60.0;
  /// Of full bone at each end; the canal is a void of its own, like marrow.
  double cap_mm = 4.0;
  /// The circles are regular polygons with corners on the radius.
  std::size_t segments = 64;
  /// Parts along the length.
  std::size_t rings = 1;
};

/// Outer shell and inward-facing canal shell as one mesh.
simulator::IndexedMesh hollow_tube(const Tube& tube);

/// A sphere with its corners on the radius: 12 * subdivisions^2 triangles, from a cube's lattice.
simulator::IndexedMesh sphere(double radius_mm, std::size_t subdivisions);

/// The smallest such sphere of at least `triangle_count` triangles.
simulator::IndexedMesh dense_sphere(double radius_mm, std::size_t triangle_count);

/// The mesh carried by a rigid motion.
simulator::IndexedMesh moved(const simulator::IndexedMesh& mesh, const RigidTransform& motion);

/// The mesh with each triangle turned over: outside becomes inside.
simulator::IndexedMesh inside_out(const simulator::IndexedMesh& mesh);

}  // namespace hallux::tests
