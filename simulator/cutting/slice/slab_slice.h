/// The contact slice: the skin of a bone between a kerf's two planes, cut once into triangles that
/// end on the planes. Inside this room only.
///
///     above        outer parts: what a crossed triangle has above +w/2
///   -- +w/2 --     contour edges, level +1
///     strip        strip triangles, between crossings and mesh points
///   -- -w/2 --     contour edges, level -1
///     below        outer parts: what a crossed triangle has below -w/2
///
/// From here on, taking a region of the slab away is a question in the plane: docs/cutting.md.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "simulator/cutting/field/kerf.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/cutting/slice/plane_lattice.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// A mesh point inside the slab, or the crossing of a mesh edge with one of the planes.
struct StripPoint {
  LatticePoint place;
  /// In lattice steps.
  std::int64_t height = 0;
  Vec3 point_in_bone_mm{0.0, 0.0, 0.0};
  /// The mesh point; none for a crossing.
  std::uint32_t base_point = no_index;
  /// A touched triangle that has it.
  std::uint32_t touched = no_index;
};

/// Runs from a to b; contour edges (level not 0) run as their strip triangle does:
/// counter-clockwise around bone on the lower plane, clockwise on the upper one.
struct StripEdge {
  std::uint32_t a = 0, b = 0;
  /// +1 or -1: lies in the upper or lower plane; 0: between them.
  std::int8_t level = 0;
  /// A touched triangle that has it.
  std::uint32_t touched = no_index;
};

struct StripTriangle {
  /// Edge k joins points k and k + 1.
  std::array<std::uint32_t, 3> points{}, edges{};
  /// Side k runs as its edge does.
  std::array<bool, 3> runs_along{};
  /// +1 where it is counter-clockwise in the plane, -1 clockwise, 0 upright.
  std::int8_t facing = 0;
  std::uint32_t touched = 0;
};

/// The part of a touched triangle beyond one plane: ring a, corners, b of its contour edge.
struct OuterPart {
  /// Its contour edge.
  std::uint32_t edge = 0;
  std::uint32_t touched = 0;
  /// Mesh points, the first `corner_count`.
  std::array<std::uint32_t, 2> corners{};
  std::uint8_t corner_count = 1;
};

/// A triangle of the mesh that reaches into the slab, with the runs of strip triangles and outer
/// parts made of it.
struct TouchedTriangle {
  std::uint32_t base_triangle = 0;
  /// Connected part of the strip.
  std::uint32_t skin = 0;
  std::uint32_t first_strip = 0, first_outer = 0;
};

struct SlabSlice {
  KerfPlane plane;
  KerfAxes axes;
  std::int32_t kerf = 0;
  PlaneLattice lattice;
  /// Box of the strip's points.
  LatticePoint min, max;
  std::uint32_t base_point_count = 0;
  std::vector<StripPoint> points;
  std::vector<StripEdge> edges;
  std::vector<StripTriangle> triangles;
  std::vector<OuterPart> outer_parts;
  /// Ascending by base_triangle.
  std::vector<TouchedTriangle> touched;
  /// Of each touched triangle.
  std::vector<FaceSource> sources;
  std::uint32_t skin_count = 0;

  /// The strip's points in an order in which each but the first of a skin comes after its parent.
  struct TreeEdge {
    std::uint32_t point = 0;
    /// None: the first of its skin.
    std::uint32_t parent = no_index;
    std::uint32_t edge = no_index;
    std::uint32_t skin = 0;
  };
  std::vector<TreeEdge> tree;
};

/// needs   solid is closed; bvh was built over solid.mesh; `min_mm`, `max_mm` is a box in the
///         kerf's plane that holds every region asked about later
/// ensures cost grows with the triangles that reach into the slab, beyond the search in the tree
/// errors  none: a plane that misses gives no points
/// thread  worker
/// source  docs/cutting.md
SlabSlice slice_slab(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane,
                     std::int32_t kerf, const Vec2& min_mm, const Vec2& max_mm);

/// The same with room for regions that a field can hold.
SlabSlice slice_slab(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane,
                     std::int32_t kerf, const FieldGrid& grid);

}  // namespace hallux::simulator
