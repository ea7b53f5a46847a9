/// The two-plane clip.
///
///        above      untouched or split triangles, then a cap that looks down       side +1
///   ---- +w/2 ----  crossings, one per mesh edge and plane
///        strip      dropped
///   ---- -w/2 ----  crossings
///        below      untouched or split triangles, then a cap that looks up         side -1
///
/// Each skin part and its cap use the same crossings in opposite directions, so the result closes without looking at
/// positions. Source: docs/cutting.md; thesis 4.4.2.
#include "simulator/cutting/cut.h"

#include <algorithm>
#include <limits>

#include "simulator/base/check.h"
#include "simulator/cutting/edge_uses.h"
#include "simulator/cutting/plane_slice.h"
#include "simulator/cutting/triangulate.h"

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
                    const SlabSide& side, std::uint32_t triangle, const FaceOrigin& origin) {
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
    result.origins.push_back(origin);
  }
}

void add_cap(CutSolid& result, const KerfAxes& axes, const SlabSide& side, std::int32_t kerf) {
  const std::vector<LatticePoint> points = snap_to_lattice(places_of(side.slice, axes));
  for (Triangle triangle : triangulate(points, side.slice.loops)) {
    if (side.side > 0) std::swap(triangle[1], triangle[2]);
    for (std::uint32_t& corner : triangle) corner += side.first_point;
    result.mesh.triangles.push_back(triangle);
    result.origins.push_back({kerf, side.side});
  }
}

SlabSide make_side(CutSolid& result, const IndexedMesh& mesh, const KerfAxes& axes,
                   std::span<const std::uint32_t> triangles, double level_mm, std::int32_t side) {
  SlabSide made{slice_plane(mesh, axes, triangles, level_mm),
                static_cast<std::uint32_t>(result.mesh.points_mm.size()), level_mm, side};
  for (const Crossing& crossing : made.slice.crossings) {
    result.mesh.points_mm.push_back(crossing.point_in_bone_mm);
  }
  return made;
}

/// Splits two triangles that share an edge at the edge's middle.
void split_shared_edge(CutSolid& solid, std::uint32_t point_a, std::uint32_t point_b,
                       std::array<std::uint32_t, 2> triangles) {
  const auto middle = static_cast<std::uint32_t>(solid.mesh.points_mm.size());
  solid.mesh.points_mm.push_back(0.5 *
                                 (solid.mesh.points_mm[point_a] + solid.mesh.points_mm[point_b]));
  for (const std::uint32_t index : triangles) {
    Triangle corners = solid.mesh.triangles[index];
    const auto is_edge_start = [&] {
      return (corners[0] == point_a && corners[1] == point_b) ||
             (corners[0] == point_b && corners[1] == point_a);
    };
    while (!is_edge_start()) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    solid.mesh.triangles[index] = {corners[0], middle, corners[2]};
    solid.mesh.triangles.push_back({middle, corners[1], corners[2]});
    solid.origins.push_back(solid.origins[index]);
  }
}

/// One round of separate_repeated_edges; false where nothing was repeated.
bool separate_once(CutSolid& solid, std::uint32_t first_triangle) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = first_triangle; i < solid.mesh.triangles.size(); ++i) chosen.push_back(i);
  const std::vector<EdgeUse> uses = edge_uses(solid.mesh.triangles, chosen);
  std::vector<bool> is_split(solid.mesh.triangles.size(), false);
  bool found = false;
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].edge == uses[first].edge) ++last;
    if (last - first <= 2) continue;
    found = true;
    const auto usable = [&](bool is_descending) {
      std::size_t i = first;
      while (i < last && (uses[i].is_descending != is_descending || is_split[uses[i].triangle])) {
        ++i;
      }
      return i;
    };
    const std::size_t up = usable(false), down = usable(true);
    if (up == last || down == last) continue;
    is_split[uses[up].triangle] = is_split[uses[down].triangle] = true;
    split_shared_edge(solid, static_cast<std::uint32_t>(uses[first].edge >> 32U),
                      static_cast<std::uint32_t>(uses[first].edge & 0xffffffffU),
                      {uses[up].triangle, uses[down].triangle});
  }
  return found;
}

/// Triangles without area can name the same pair of points twice; half-edge meshes refuse that. Each such edge gets a
/// point of its own in its middle, until no pair is repeated. Edges of untouched triangles are never among them.
void separate_repeated_edges(CutSolid& solid, std::uint32_t first_triangle) {
  while (separate_once(solid, first_triangle)) {
  }
}

/// Leaves out the points that no triangle uses; the others keep their order.
void drop_unused_points(IndexedMesh& mesh) {
  std::vector<std::uint32_t> new_index(mesh.points_mm.size(), 0);
  for (const Triangle& corners : mesh.triangles) {
    for (const std::uint32_t corner : corners) new_index[corner] = 1;
  }
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    if (new_index[i] == 0) continue;
    mesh.points_mm[count] = mesh.points_mm[i];
    new_index[i] = count++;
  }
  mesh.points_mm.resize(count);
  for (Triangle& corners : mesh.triangles) {
    for (std::uint32_t& corner : corners) corner = new_index[corner];
  }
}

std::vector<std::uint8_t> flags_by_field(const SectionMask& mask, const KerfField& field,
                                         bool wants_all) {
  CHECK(mask.grid.u_count == field.grid().u_count && mask.grid.v_count == field.grid().v_count);
  std::vector<std::uint8_t> all_open(mask.fits_grid), any_open(mask.fits_grid.size(), 0);
  const auto look_at = [&](std::int32_t node, std::int16_t region) {
    if (field.at(node % mask.grid.u_count, node / mask.grid.u_count) > 0.0F) {
      any_open[static_cast<std::size_t>(region)] = 1;
    } else {
      all_open[static_cast<std::size_t>(region)] = 0;
    }
  };
  for (std::size_t node = 0; node < mask.region_of_node.size(); ++node) {
    const std::int16_t region = mask.region_of_node[node];
    if (region >= 0) look_at(static_cast<std::int32_t>(node), region);
  }
  for (const SharedNode& shared : mask.shared_nodes) look_at(shared.node, shared.region);
  return wants_all ? all_open : any_open;
}

}  // namespace

std::vector<std::uint8_t> covered_regions(const SectionMask& mask, const KerfField& field) {
  return flags_by_field(mask, field, true);
}

std::vector<std::uint8_t> touched_regions(const SectionMask& mask, const KerfField& field) {
  return flags_by_field(mask, field, false);
}

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
    result.origins.push_back(solid.origins[i]);
  }
  const auto first_new = static_cast<std::uint32_t>(result.mesh.triangles.size());
  const KerfAxes axes = axes_of(section.plane);
  const double half_mm = 0.5 * section.plane.thickness_mm;
  for (const std::int32_t side_sign : {1, -1}) {
    const SlabSide side =
        make_side(result, solid.mesh, axes, touched, side_sign * half_mm, side_sign);
    for (const std::uint32_t triangle : touched) {
      add_outer_part(result, solid.mesh, axes, side, triangle, solid.origins[triangle]);
    }
    add_cap(result, axes, side, kerf);
  }
  separate_repeated_edges(result, first_new);
  drop_unused_points(result.mesh);
  return result;
}

}  // namespace hallux::simulator
