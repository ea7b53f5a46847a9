/// The two-plane clip.
///
///        above      untouched or split triangles, then a cap that looks down       side +1
///   ---- +w/2 ----  crossings, one per mesh edge and plane
///        strip      dropped
///   ---- -w/2 ----  crossings
///        below      untouched or split triangles, then a cap that looks up         side -1
///
/// Each skin part and its cap use the same crossings in opposite directions, so the result closes
/// without looking at positions. Source: docs/cutting.md; thesis 4.4.2.
#include "simulator/cutting/solid/remove_slab.h"

#include <algorithm>

#include "simulator/base/check.h"
#include "simulator/cutting/fill/triangulate.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/cutting/solid/mend_solid.h"

namespace hallux::simulator {

namespace {

struct SlabSide {
  PlaneSlice slice;
  std::uint32_t first_point = 0;  ///< index of the slice's first crossing among the result's points
  double level_mm = 0.0;
  std::int32_t side = 1;  ///< +1: what stands at or above the level is kept; -1: what lies below it

  bool keeps(double corner_mm) const noexcept { return (corner_mm >= level_mm) == (side > 0); }
};

/// Adds the part of a triangle on one side, as a fan.
void add_outer_part(CutSolid& result, const IndexedMesh& mesh, const KerfAxes& axes,
                    const SlabSide& side, std::uint32_t triangle, const FaceSource& source) {
  const Triangle& corners = mesh.triangles[triangle];
  std::array<bool, 3> is_kept{};
  for (std::size_t i = 0; i < 3; ++i) {
    is_kept[i] = side.keeps(height_mm(axes, mesh.points_mm[corners[i]]));
  }
  std::array<std::uint32_t, 4> polygon{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (is_kept[i]) polygon[count++] = corners[i];
    if (is_kept[i] != is_kept[j]) {
      polygon[count++] = side.first_point + crossing_on(side.slice, corners[i], corners[j]);
    }
  }
  for (std::size_t i = 2; i < count; ++i) {
    result.mesh.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
    result.sources.push_back(source);
  }
}

void add_cap(CutSolid& result, const KerfAxes& axes, const SlabSide& side, std::int32_t kerf) {
  const std::vector<LatticePoint> points = snap_to_lattice(places_of(side.slice, axes));
  for (Triangle triangle : triangulate(points, side.slice.loops)) {
    if (side.side > 0) std::swap(triangle[1], triangle[2]);
    for (std::uint32_t& corner : triangle) corner += side.first_point;
    result.mesh.triangles.push_back(triangle);
    result.sources.push_back({kerf, side.side});
  }
}

SlabSide make_side(CutSolid& result, const IndexedMesh& mesh, const KerfAxes& axes,
                   std::span<const std::uint32_t> triangles, double level_mm, std::int32_t side) {
  SlabSide made{slice_plane(mesh, axes, triangles, level_mm),
                static_cast<std::uint32_t>(result.mesh.points_mm.size()), level_mm, side};
  for (const EdgeCrossing& crossing : made.slice.crossings) {
    result.mesh.points_mm.push_back(crossing.point_in_bone_mm);
  }
  return made;
}

}  // namespace

CutSolid remove_slab(const CutSolid& solid, const Bvh&, const Section& section, std::int32_t kerf,
                     std::span<const std::uint8_t> is_removed) {
  CHECK(is_removed.size() == section.regions.size());
  std::vector<std::uint32_t> touched;
  for (std::size_t i = 0; i < section.regions.size(); ++i) {
    if (is_removed[i] == 0) continue;
    const std::vector<std::uint32_t>& triangles = section.regions[i].triangles;
    touched.insert(touched.end(), triangles.begin(), triangles.end());
  }
  if (touched.empty()) return solid;
  std::sort(touched.begin(), touched.end());

  CutSolid result;
  result.mesh.points_mm = solid.mesh.points_mm;
  for (std::uint32_t i = 0, next = 0; i < solid.mesh.triangles.size(); ++i) {
    if (next < touched.size() && touched[next] == i) {
      ++next;
      continue;
    }
    result.mesh.triangles.push_back(solid.mesh.triangles[i]);
    result.sources.push_back(solid.sources[i]);
  }
  const auto first_new = static_cast<std::uint32_t>(result.mesh.triangles.size());
  const KerfAxes axes = axes_of(section.plane);
  const double half_mm = 0.5 * section.plane.thickness_mm;
  for (const std::int32_t side_sign : {1, -1}) {
    const SlabSide side =
        make_side(result, solid.mesh, axes, touched, side_sign * half_mm, side_sign);
    for (const std::uint32_t triangle : touched) {
      add_outer_part(result, solid.mesh, axes, side, triangle, solid.sources[triangle]);
    }
    add_cap(result, axes, side, kerf);
  }
  separate_repeated_edges(result, first_new);
  drop_unused_points(result.mesh);
  return result;
}

}  // namespace hallux::simulator
