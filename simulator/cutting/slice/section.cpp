/// What hangs together in the slab is one region: skins that share an edge there, a canal and the
/// skin around it, a void between the planes and the bone that a ray from it meets first. Sets of
/// triangles are joined until that holds. A region is found from its skin and not from one plane's
/// contours, which may fall apart where a bone is hollow or bent.
#include "simulator/cutting/slice/section.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/pieces/edge_uses.h"
#include "simulator/cutting/slice/nesting.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/cutting/slice/slab_query.h"

namespace hallux::simulator {

namespace {

bool edge_reaches_into_slab(const IndexedMesh& mesh, const KerfAxes& axes, std::uint64_t edge,
                            double half_mm) noexcept {
  const auto part_of = [&](std::uint64_t point) {
    return slab_part(height_mm(axes, mesh.points_mm[point]), half_mm);
  };
  const SlabPart a = part_of(edge & 0xffffffffU), b = part_of(edge >> 32U);
  return a != b || a == SlabPart::Inside;
}

/// The slab's skin, its parts joined step by step until each set is one region.
class Strip {
 public:
  Strip(const IndexedMesh& mesh, const Bvh& bvh, const KerfPlane& plane);
  std::vector<std::vector<std::uint32_t>> regions();

 private:
  void join_neighbours();
  void join_nested(double level_mm);
  void join_enclosed_voids();
  std::uint32_t place_in_strip(std::uint32_t triangle) const noexcept;
  /// The triangle that a ray along x, from a point in the slab and in the plane, meets first
  /// outside its own part.
  std::optional<std::uint32_t> first_ahead(const Vec3& point_in_bone_mm, std::uint32_t own_root);

  const IndexedMesh& mesh_;
  KerfAxes axes_;
  double half_mm_;
  std::vector<std::uint32_t> triangles_;  // ascending
  DisjointSets parts_;                    // of places in triangles_
  std::vector<std::uint8_t> has_loop_;    // per place, at roots of the skin's connected parts
};

Strip::Strip(const IndexedMesh& mesh, const Bvh& bvh, const KerfPlane& plane)
    : mesh_(mesh),
      axes_(axes_of(plane)),
      half_mm_(0.5 * plane.thickness_mm),
      triangles_(triangles_reaching_slab(mesh, bvh, axes_, half_mm_)),
      parts_(triangles_.size()),
      has_loop_(triangles_.size(), 0) {}

std::uint32_t Strip::place_in_strip(std::uint32_t triangle) const noexcept {
  const auto found = std::lower_bound(triangles_.begin(), triangles_.end(), triangle);
  return static_cast<std::uint32_t>(found - triangles_.begin());
}

void Strip::join_neighbours() {
  const std::vector<EdgeUse> uses = edge_uses(mesh_.triangles, triangles_);
  for (std::size_t i = 1; i < uses.size(); ++i) {
    if (uses[i].edge != uses[i - 1].edge) continue;
    if (!edge_reaches_into_slab(mesh_, axes_, uses[i].edge, half_mm_)) continue;
    parts_.join(place_in_strip(uses[i].triangle), place_in_strip(uses[i - 1].triangle));
  }
}

void Strip::join_nested(double level_mm) {
  const PlaneSlice slice = slice_plane(mesh_, axes_, triangles_, level_mm);
  const std::vector<LatticePoint> points = snap_to_lattice(places_of(slice, axes_));
  const std::vector<std::int32_t> around = loops_around(points, slice.loops);
  const auto part_of = [&](std::size_t loop) {
    return place_in_strip(slice.crossings[slice.loops[loop].front()].triangle);
  };
  for (std::size_t loop = 0; loop < slice.loops.size(); ++loop) {
    has_loop_[part_of(loop)] = 1;
    if (around[loop] < 0) continue;
    parts_.join(part_of(loop), part_of(static_cast<std::size_t>(around[loop])));
  }
}

std::optional<std::uint32_t> Strip::first_ahead(const Vec3& point_in_bone_mm,
                                                std::uint32_t own_root) {
  const Vec2 start = place_mm(axes_, point_in_bone_mm);
  const double level_mm = height_mm(axes_, point_in_bone_mm);
  double nearest_mm = std::numeric_limits<double>::infinity();
  std::optional<std::uint32_t> found;
  for (std::uint32_t place = 0; place < triangles_.size(); ++place) {
    if (parts_.root(place) == own_root) continue;
    const StripPolygon line = strip_polygon(mesh_, axes_, triangles_[place], half_mm_);
    std::array<Vec2, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < line.count && count < 2; ++i) {
      const Vec3& a = line.corners_in_kerf_mm[i];
      const Vec3& b = line.corners_in_kerf_mm[(i + 1) % line.count];
      if ((a.z >= level_mm) == (b.z >= level_mm)) continue;
      const Vec3 at = a + (level_mm - a.z) / (b.z - a.z) * (b - a);
      ends[count++] = Vec2(at.x, at.y);
    }
    if (count < 2 || (ends[0].y >= start.y) == (ends[1].y >= start.y)) continue;
    const double part = (start.y - ends[0].y) / (ends[1].y - ends[0].y);
    const double ahead_mm = ends[0].x + part * (ends[1].x - ends[0].x) - start.x;
    if (ahead_mm < 0.0 || ahead_mm >= nearest_mm) continue;
    nearest_mm = ahead_mm;
    found = place;
  }
  return found;
}

/// A void that lies wholly between the planes has no loop on either; it belongs to the bone around
/// it.
void Strip::join_enclosed_voids() {
  std::map<std::uint32_t, double> loopless_mm3;  // six times the volume, by root
  std::map<std::uint32_t, bool> is_looped;
  for (std::uint32_t place = 0; place < triangles_.size(); ++place) {
    if (has_loop_[place] != 0) is_looped[parts_.root(place)] = true;
  }
  for (std::uint32_t place = 0; place < triangles_.size(); ++place) {
    const std::uint32_t root = parts_.root(place);
    if (is_looped.contains(root)) continue;
    const auto [a, b, c] = corners_of(mesh_, triangles_[place]);
    loopless_mm3[root] +=
        glm::dot(a - axes_.origin_mm, glm::cross(b - axes_.origin_mm, c - axes_.origin_mm));
  }
  for (const auto& [root, volume_mm3] : loopless_mm3) {
    if (volume_mm3 >= 0.0) continue;
    const Vec3 first_mm = corners_of(mesh_, triangles_[root])[0];
    const auto around = first_ahead(first_mm, parts_.root(root));
    if (around) parts_.join(root, *around);
  }
}

std::vector<std::vector<std::uint32_t>> Strip::regions() {
  if (triangles_.empty()) return {};
  join_neighbours();
  join_nested(half_mm_);
  join_nested(-half_mm_);
  join_enclosed_voids();
  std::vector<std::vector<std::uint32_t>> regions = parts_.groups();
  for (std::vector<std::uint32_t>& region : regions) {
    for (std::uint32_t& place : region) place = triangles_[place];
  }
  return regions;
}

void measure_extent(SectionRegion& region, const IndexedMesh& mesh, const KerfAxes& axes,
                    double half_mm) {
  region.min_mm = Vec2(std::numeric_limits<double>::infinity());
  region.max_mm = -region.min_mm;
  for (const std::uint32_t triangle : region.triangles) {
    const StripPolygon polygon = strip_polygon(mesh, axes, triangle, half_mm);
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const Vec2 corner_mm(polygon.corners_in_kerf_mm[i].x, polygon.corners_in_kerf_mm[i].y);
      region.min_mm = glm::min(region.min_mm, corner_mm);
      region.max_mm = glm::max(region.max_mm, corner_mm);
    }
  }
}

void measure_section(SectionRegion& region, const IndexedMesh& mesh, const KerfAxes& axes) {
  const PlaneSlice slice = slice_plane(mesh, axes, region.triangles, 0.0);
  const std::vector<Vec2> places_mm = places_of(slice, axes);
  for (const Loop& loop : slice.loops) {
    Contour& contour = region.contours.emplace_back();
    for (const std::uint32_t crossing : loop) contour.push_back(places_mm[crossing]);
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2 a = contour[i] - contour.front();
      const Vec2 b = contour[(i + 1) % contour.size()] - contour.front();
      region.area_mm2 += 0.5 * cross(a, b);
    }
  }
}

}  // namespace

Section slice_section(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane) {
  Section section;
  section.plane = plane;
  const KerfAxes axes = axes_of(plane);
  for (std::vector<std::uint32_t>& triangles : Strip(solid.mesh, bvh, plane).regions()) {
    SectionRegion& region = section.regions.emplace_back();
    region.triangles = std::move(triangles);
    measure_extent(region, solid.mesh, axes, 0.5 * plane.thickness_mm);
    measure_section(region, solid.mesh, axes);
  }
  std::sort(section.regions.begin(), section.regions.end(),
            [](const SectionRegion& a, const SectionRegion& b) {
              return std::pair(-a.area_mm2, a.triangles.front()) <
                     std::pair(-b.area_mm2, b.triangles.front());
            });
  return section;
}

KerfOpening opening_of(const KerfPlane& plane, const KerfField& field) {
  return {plane, loops_of(outline_of(field))};
}

}  // namespace hallux::simulator
