/// Which triangles of a mesh reach into a kerf's slab. Inside this corner only.
///
/// A point at or above +thickness/2 is above the slab, one below -thickness/2 is below it, and
/// nothing else decides: so a plane always crosses edges between their ends, whatever touches it.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

enum class SlabPart : std::int8_t { Below = -1, Inside = 0, Above = 1 };

inline SlabPart slab_part(double height_mm, double half_mm) noexcept {
  if (height_mm >= half_mm) return SlabPart::Above;
  return height_mm < -half_mm ? SlabPart::Below : SlabPart::Inside;
}

/// The triangles that are neither wholly above nor wholly below the slab, in ascending order, found
/// through the tree: an adjacency walk from the skin would never reach a canal's shell.
std::vector<std::uint32_t> triangles_reaching_slab(const IndexedMesh& mesh, const Bvh& bvh,
                                                   const KerfAxes& axes, double half_mm);

/// A corner of such a triangle.
struct SlabCorner {
  Vec3 point_in_bone_mm{0.0, 0.0, 0.0};
  double height_mm = 0.0;
  /// The mesh point.
  std::uint32_t base_point = 0;
  SlabPart part = SlabPart::Inside;
};

/// The same triangles with all that is asked about them, gathered from the mesh once.
struct SlabSkin {
  /// Of the mesh, ascending.
  std::vector<std::uint32_t> triangles;
  /// Per triangle, indices of points.
  std::vector<Triangle> corners;
  /// Each mesh point once.
  std::vector<SlabCorner> points;
};
SlabSkin gather_slab_skin(const IndexedMesh& mesh, const Bvh& bvh, const KerfAxes& axes,
                          double half_mm);

}  // namespace hallux::simulator
