/// Where planes parallel to a kerf cut a closed mesh: loops of crossings named by mesh edge, never
/// by position. Inside this room only.
///
/// A point on the plane counts as above it, so a plane always crosses edges between their ends,
/// whatever touches it: every crossing has one loop segment before and one behind it, and every
/// loop closes by construction.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/cutting/field/kerf.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// The kerf's frame written out, in the bone frame.
struct KerfAxes {
  Vec3 origin_mm, x, y, z;
};

KerfAxes axes_of(const KerfPlane& plane) noexcept;
/// Height above the kerf's middle plane [mm].
inline double height_mm(const KerfAxes& axes, const Vec3& point_in_bone_mm) noexcept {
  return glm::dot(axes.z, point_in_bone_mm - axes.origin_mm);
}
/// Place in the kerf's plane [mm].
inline Vec2 place_mm(const KerfAxes& axes, const Vec3& point_in_bone_mm) noexcept {
  const Vec3 arm_mm = point_in_bone_mm - axes.origin_mm;
  return {glm::dot(axes.x, arm_mm), glm::dot(axes.y, arm_mm)};
}

/// A mesh edge that the plane crosses; low < high are indices of mesh points.
struct EdgeCrossing {
  std::uint32_t low = 0, high = 0;
  /// The one whose segment begins here.
  std::uint32_t triangle = 0;
  Vec3 point_in_bone_mm{0.0, 0.0, 0.0};
};

/// Indices of crossings, counter-clockwise around bone.
using Loop = std::vector<std::uint32_t>;

struct PlaneSlice {
  /// Ascending by (low, high).
  std::vector<EdgeCrossing> crossings;
  /// Every crossing lies in exactly one.
  std::vector<Loop> loops;
};

/// The loops at height `level_mm` over the given triangles.
/// needs   with a triangle, `triangles` holds its neighbours across every edge that the plane
///         crosses
PlaneSlice slice_plane(const IndexedMesh& mesh, const KerfAxes& axes,
                       std::span<const std::uint32_t> triangles, double level_mm);
/// The index of the crossing on the edge between two mesh points.
/// needs   the plane crosses that edge
std::uint32_t crossing_on(const PlaneSlice& slice, std::uint32_t point_a, std::uint32_t point_b);
/// The places of all crossings in the kerf's plane [mm].
std::vector<Vec2> places_of(const PlaneSlice& slice, const KerfAxes& axes);

/// A convex polygon of at most five corners, in the kerf frame [mm].
struct StripPolygon {
  std::array<Vec3, 5> corners_in_kerf_mm;
  std::size_t count = 0;
};
/// The part of a triangle between the heights -half and +half.
StripPolygon strip_polygon(const IndexedMesh& mesh, const KerfAxes& axes, std::uint32_t triangle,
                           double half_mm) noexcept;

}  // namespace hallux::simulator
