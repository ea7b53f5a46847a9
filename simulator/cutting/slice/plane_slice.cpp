#include "simulator/cutting/slice/plane_slice.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "simulator/base/check.h"

namespace hallux::simulator {

namespace {

constexpr std::uint32_t no_crossing = std::numeric_limits<std::uint32_t>::max();

/// The triangle's edges through which its contour enters (its walk goes down) and leaves (up).
struct Segment {
  std::array<std::uint32_t, 2> down_edge{}, up_edge{};
  std::uint32_t triangle = 0;
};

std::array<std::uint32_t, 2> ordered(std::uint32_t a, std::uint32_t b) noexcept {
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Segment> segments_at(const IndexedMesh& mesh, const KerfAxes& axes,
                                 std::span<const std::uint32_t> triangles, double level_mm) {
  std::vector<Segment> segments;
  for (const std::uint32_t index : triangles) {
    const Triangle& corners = mesh.triangles[index];
    std::array<bool, 3> is_above{};
    for (std::size_t i = 0; i < 3; ++i) {
      is_above[i] = height_mm(axes, mesh.points_mm[corners[i]]) >= level_mm;
    }
    if (is_above[0] == is_above[1] && is_above[1] == is_above[2]) continue;
    Segment segment;
    segment.triangle = index;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (is_above[i] && !is_above[j]) segment.down_edge = ordered(corners[i], corners[j]);
      if (!is_above[i] && is_above[j]) segment.up_edge = ordered(corners[i], corners[j]);
    }
    segments.push_back(segment);
  }
  return segments;
}

Vec3 crossing_point(const IndexedMesh& mesh, const KerfAxes& axes, const EdgeCrossing& crossing,
                    double level_mm) noexcept {
  const Vec3& low = mesh.points_mm[crossing.low];
  const Vec3& high = mesh.points_mm[crossing.high];
  const double low_mm = height_mm(axes, low);
  const double part = (level_mm - low_mm) / (height_mm(axes, high) - low_mm);
  return low + std::clamp(part, 0.0, 1.0) * (high - low);
}

std::vector<Loop> loops_from(const std::vector<std::uint32_t>& next) {
  std::vector<Loop> loops;
  std::vector<bool> is_used(next.size(), false);
  for (std::uint32_t start = 0; start < next.size(); ++start) {
    if (is_used[start]) continue;
    Loop& loop = loops.emplace_back();
    for (std::uint32_t at = start; !is_used[at]; at = next[at]) {
      is_used[at] = true;
      loop.push_back(at);
    }
  }
  return loops;
}

/// Sutherland and Hodgman's clip against one plane: keeps where sign * height <= half.
StripPolygon clipped(const StripPolygon& polygon, double sign, double half_mm) noexcept {
  StripPolygon kept;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3& a = polygon.corners_in_kerf_mm[i];
    const Vec3& b = polygon.corners_in_kerf_mm[(i + 1) % polygon.count];
    const double a_over_mm = sign * a.z - half_mm;
    const double b_over_mm = sign * b.z - half_mm;
    if (a_over_mm <= 0.0) kept.corners_in_kerf_mm[kept.count++] = a;
    if ((a_over_mm <= 0.0) != (b_over_mm <= 0.0)) {
      const double part = a_over_mm / (a_over_mm - b_over_mm);
      kept.corners_in_kerf_mm[kept.count++] = a + part * (b - a);
    }
  }
  return kept;
}

}  // namespace

KerfAxes axes_of(const KerfPlane& plane) noexcept {
  const RigidTransform& bone_from_kerf = plane.bone_from_kerf;
  return {bone_from_kerf.translation_mm, axis_x(bone_from_kerf), axis_y(bone_from_kerf),
          axis_z(bone_from_kerf)};
}

PlaneSlice slice_plane(const IndexedMesh& mesh, const KerfAxes& axes,
                       std::span<const std::uint32_t> triangles, double level_mm) {
  const std::vector<Segment> segments = segments_at(mesh, axes, triangles, level_mm);
  PlaneSlice slice;
  for (const Segment& segment : segments) {
    slice.crossings.push_back({segment.down_edge[0], segment.down_edge[1], segment.triangle});
  }
  std::sort(slice.crossings.begin(), slice.crossings.end(),
            [](const EdgeCrossing& a, const EdgeCrossing& b) {
              return std::pair(a.low, a.high) < std::pair(b.low, b.high);
            });
  for (EdgeCrossing& crossing : slice.crossings) {
    crossing.point_in_bone_mm = crossing_point(mesh, axes, crossing, level_mm);
  }
  std::vector<std::uint32_t> next(slice.crossings.size(), no_crossing);
  for (const Segment& segment : segments) {
    const std::uint32_t from = crossing_on(slice, segment.down_edge[0], segment.down_edge[1]);
    CHECK(next[from] == no_crossing);
    next[from] = crossing_on(slice, segment.up_edge[0], segment.up_edge[1]);
  }
  slice.loops = loops_from(next);
  return slice;
}

std::uint32_t crossing_on(const PlaneSlice& slice, std::uint32_t point_a, std::uint32_t point_b) {
  const std::array<std::uint32_t, 2> edge = ordered(point_a, point_b);
  const auto found = std::lower_bound(
      slice.crossings.begin(), slice.crossings.end(), edge,
      [](const EdgeCrossing& crossing, const std::array<std::uint32_t, 2>& wanted) {
        return std::pair(crossing.low, crossing.high) < std::pair(wanted[0], wanted[1]);
      });
  CHECK(found != slice.crossings.end() && found->low == edge[0] && found->high == edge[1]);
  return static_cast<std::uint32_t>(found - slice.crossings.begin());
}

std::vector<Vec2> places_of(const PlaneSlice& slice, const KerfAxes& axes) {
  std::vector<Vec2> places;
  places.reserve(slice.crossings.size());
  for (const EdgeCrossing& crossing : slice.crossings) {
    places.push_back(place_mm(axes, crossing.point_in_bone_mm));
  }
  return places;
}

StripPolygon strip_polygon(const IndexedMesh& mesh, const KerfAxes& axes, std::uint32_t triangle,
                           double half_mm) noexcept {
  StripPolygon whole;
  for (const std::uint32_t corner : mesh.triangles[triangle]) {
    const Vec3& point_mm = mesh.points_mm[corner];
    const Vec2 place = place_mm(axes, point_mm);
    whole.corners_in_kerf_mm[whole.count++] = Vec3(place.x, place.y, height_mm(axes, point_mm));
  }
  return clipped(clipped(whole, 1.0, half_mm), -1.0, half_mm);
}

}  // namespace hallux::simulator
