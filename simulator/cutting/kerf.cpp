#include "simulator/cutting/kerf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "simulator/base/check.h"

namespace hallux::simulator {

namespace {

constexpr double limit_spacings = 2.0;
/// Poses are whole micrometres and micro-units: a shorter hull edge is noise of rounding, with a direction of its own.
constexpr double shortest_edge_mm = 1.0e-6;
constexpr double flattest_slope = 1.0e-12;

/// The inside-distance to one edge of the hull: along_u * u + along_v * v + at_origin, u and v counted in nodes [mm].
struct HullEdge {
  double along_u = 0.0, along_v = 0.0, at_origin = 0.0;
  double nodes_per_mm = 0.0;  ///< 1 / along_u; 0 where the edge runs along the rows
};

struct Hull {
  std::array<HullEdge, 8> edges;
  std::size_t count = 0;
  double v_min_mm = 0.0, v_max_mm = 0.0;
};

double cross(const Vec2& a, const Vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

void add_rectangle(const BladeSize& blade, const PlanarPose& pose, Vec2* corners_mm) noexcept {
  const Vec2 side_mm = 0.5 * blade.width_mm * Vec2(-pose.direction.y, pose.direction.x);
  const Vec2 back_mm = pose.tip_mm - blade.depth_mm * pose.direction;
  corners_mm[0] = pose.tip_mm - side_mm;
  corners_mm[1] = pose.tip_mm + side_mm;
  corners_mm[2] = back_mm - side_mm;
  corners_mm[3] = back_mm + side_mm;
}

/// Andrew's monotone chain (1979): the hull counter-clockwise, at most eight corners; returns their count.
std::size_t hull_corners(std::array<Vec2, 8>& points_mm, std::array<Vec2, 17>& hull_mm) noexcept {
  std::sort(points_mm.begin(), points_mm.end(),
            [](const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::size_t count = 0, floor = 2;
  const auto add = [&](const Vec2& point_mm) {
    while (count >= floor &&
           cross(hull_mm[count - 1] - hull_mm[count - 2], point_mm - hull_mm[count - 2]) <= 0.0) {
      --count;
    }
    hull_mm[count++] = point_mm;
  };
  for (const Vec2& point_mm : points_mm) add(point_mm);
  floor = count + 1;
  for (std::size_t i = points_mm.size() - 1; i-- > 0;) add(points_mm[i]);
  return count - 1;
}

Hull hull_of(const FieldGrid& grid, const BladeSize& blade, const PlanarPose& from,
             const PlanarPose& to) noexcept {
  std::array<Vec2, 8> points_mm;
  std::array<Vec2, 17> corners_mm;
  add_rectangle(blade, from, points_mm.data());
  add_rectangle(blade, to, points_mm.data() + 4);
  const std::size_t corner_count = hull_corners(points_mm, corners_mm);
  Hull hull;
  hull.v_min_mm = std::numeric_limits<double>::infinity();
  hull.v_max_mm = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corner_count; ++i) {
    const Vec2 a_mm = corners_mm[i] - grid.origin_mm;
    const Vec2 edge_mm = corners_mm[i + 1] - corners_mm[i];
    hull.v_min_mm = std::min(hull.v_min_mm, a_mm.y);
    hull.v_max_mm = std::max(hull.v_max_mm, a_mm.y);
    const double length_mm = std::sqrt(edge_mm.x * edge_mm.x + edge_mm.y * edge_mm.y);
    if (length_mm < shortest_edge_mm) continue;
    const Vec2 inward(-edge_mm.y / length_mm, edge_mm.x / length_mm);
    HullEdge& edge = hull.edges[hull.count++];
    edge = {inward.x * grid.spacing_mm, inward.y * grid.spacing_mm,
            -(inward.x * a_mm.x + inward.y * a_mm.y), 0.0};
    if (std::abs(edge.along_u) > flattest_slope) edge.nodes_per_mm = 1.0 / edge.along_u;
  }
  return hull;
}

bool is_finite(const PlanarPose& pose) noexcept {
  return std::isfinite(pose.tip_mm.x) && std::isfinite(pose.tip_mm.y) &&
         std::isfinite(pose.direction.x) && std::isfinite(pose.direction.y);
}

std::int32_t clamped_node(double value, std::int32_t count) noexcept {
  return static_cast<std::int32_t>(std::clamp(value, 0.0, static_cast<double>(count)));
}

void take_in(FieldWindow& window, std::int32_t u, std::int32_t v) noexcept {
  if (window.is_empty()) {
    window = {u, v, u + 1, v + 1};
    return;
  }
  window.u_first = std::min(window.u_first, u);
  window.v_first = std::min(window.v_first, v);
  window.u_last = std::max(window.u_last, u + 1);
  window.v_last = std::max(window.v_last, v + 1);
}

}  // namespace

/// One row of nodes against the hull. All is a function of stamp and node alone, never of what was stamped before.
struct KerfField::HullRow {
  const Hull& hull;
  std::int32_t v;
  std::array<double, 8> at_row{};  ///< per edge: the inside-distance at u = 0
  std::size_t rising_edge = 0, falling_edge = 0, middle_edge = 0;

  HullRow(const Hull& hull_in, std::int32_t v_in) noexcept : hull(hull_in), v(v_in) {
    for (std::size_t i = 0; i < hull.count; ++i) {
      at_row[i] = hull.edges[i].along_v * static_cast<double>(v) + hull.edges[i].at_origin;
    }
  }
  double distance_mm(std::size_t edge, std::int32_t u) const noexcept {
    return hull.edges[edge].along_u * static_cast<double>(u) + at_row[edge];
  }
  /// The nodes where every edge is at least `depth_mm` away inwards.
  RowSpan deeper_than(double depth_mm, std::int32_t u_count) noexcept {
    double first = 0.0, last = static_cast<double>(u_count) - 1.0;
    for (std::size_t i = 0; i < hull.count; ++i) {
      const double nodes_per_mm = hull.edges[i].nodes_per_mm;
      const double bound = (depth_mm - at_row[i]) * nodes_per_mm;
      if (nodes_per_mm == 0.0 && at_row[i] < depth_mm) return {};
      if (nodes_per_mm > 0.0 && bound > first) {
        first = bound;
        rising_edge = i;
      } else if (nodes_per_mm < 0.0 && bound < last) {
        last = bound;
        falling_edge = i;
      }
    }
    if (first > last) return {};
    // Conversion cuts towards 0, so for numbers from 0 up it rounds down; the bounds lie within the row.
    const auto whole = static_cast<std::int32_t>(first);
    return {static_cast<double>(whole) < first ? whole + 1 : whole,
            static_cast<std::int32_t>(last) + 1};
  }
  /// Finds the edge that is nearest in the middle of a span without deep nodes.
  void look_at_middle(const RowSpan& span) noexcept {
    const std::int32_t u = span.first + (span.last - span.first) / 2;
    for (std::size_t i = 0; i < hull.count; ++i) {
      if (distance_mm(i, u) < distance_mm(middle_edge, u)) middle_edge = i;
    }
  }
  /// The least over the edges that most likely hold it; the least over all is not more.
  double likely_inside_mm(std::int32_t u) const noexcept {
    return std::min(distance_mm(middle_edge, u),
                    std::min(distance_mm(rising_edge, u), distance_mm(falling_edge, u)));
  }
};

PlanarPose planar_pose(const KerfPlane& plane, const RigidTransform& bone_from_tool) noexcept {
  const RigidTransform kerf_from_tool = inverse(plane.bone_from_kerf) * bone_from_tool;
  const Vec3 direction = transform_direction(kerf_from_tool, Vec3(1.0, 0.0, 0.0));
  const double length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  PlanarPose pose;
  pose.tip_mm = Vec2(kerf_from_tool.translation_mm.x, kerf_from_tool.translation_mm.y);
  if (length > 0.0) pose.direction = Vec2(direction.x / length, direction.y / length);
  return pose;
}

KerfField::KerfField(const FieldGrid& grid)
    : grid_(grid), limit_mm_(static_cast<float>(limit_spacings * grid.spacing_mm)) {
  CHECK(grid.spacing_mm > 0.0 && grid.u_count > 0 && grid.v_count > 0);
  inside_mm_.resize(static_cast<std::size_t>(grid.u_count) *
                    static_cast<std::size_t>(grid.v_count));
  deep_.resize(static_cast<std::size_t>(grid.v_count));
  reset();
}

float KerfField::at(std::int32_t u, std::int32_t v) const noexcept {
  return inside_mm_[static_cast<std::size_t>(v) * static_cast<std::size_t>(grid_.u_count) +
                    static_cast<std::size_t>(u)];
}

bool KerfField::is_open(const Vec2& point_mm) const noexcept {
  const Vec2 node = (point_mm - grid_.origin_mm) / grid_.spacing_mm;
  const double u_floor = std::floor(node.x), v_floor = std::floor(node.y);
  if (!(u_floor >= 0.0 && v_floor >= 0.0 && u_floor + 1.0 < grid_.u_count &&
        v_floor + 1.0 < grid_.v_count)) {
    return false;
  }
  const auto u = static_cast<std::int32_t>(u_floor), v = static_cast<std::int32_t>(v_floor);
  const double part_u = node.x - u_floor, part_v = node.y - v_floor;
  const double lower =
      (1.0 - part_u) * static_cast<double>(at(u, v)) + part_u * static_cast<double>(at(u + 1, v));
  const double upper = (1.0 - part_u) * static_cast<double>(at(u, v + 1)) +
                       part_u * static_cast<double>(at(u + 1, v + 1));
  return (1.0 - part_v) * lower + part_v * upper > 0.0;
}

void KerfField::reset() noexcept {
  std::fill(inside_mm_.begin(), inside_mm_.end(), -limit_mm_);
  std::fill(deep_.begin(), deep_.end(), RowSpan{});
}

bool KerfField::raise(std::size_t node, float inside_mm) noexcept {
  if (inside_mm <= inside_mm_[node]) return false;
  inside_mm_[node] = inside_mm;
  return true;
}

void KerfField::raise_rim(const HullRow& row, std::int32_t first, std::int32_t last,
                          FieldWindow& changed) noexcept {
  const std::size_t row_start =
      static_cast<std::size_t>(row.v) * static_cast<std::size_t>(grid_.u_count);
  for (std::int32_t u = first; u < last; ++u) {
    const std::size_t node = row_start + static_cast<std::size_t>(u);
    // The least over all edges cannot rise above what is there where the least over some cannot.
    const double likely_mm = std::min(row.likely_inside_mm(u), static_cast<double>(limit_mm_));
    if (static_cast<float>(likely_mm) <= inside_mm_[node]) continue;
    double inside_mm = likely_mm;
    for (std::size_t i = 0; i < row.hull.count; ++i) {
      inside_mm = std::min(inside_mm, row.distance_mm(i, u));
    }
    if (raise(node, static_cast<float>(inside_mm))) take_in(changed, u, row.v);
  }
}

void KerfField::fill_deep(std::int32_t v, RowSpan wanted, FieldWindow& changed) noexcept {
  RowSpan& known = deep_[static_cast<std::size_t>(v)];
  const std::size_t row_start =
      static_cast<std::size_t>(v) * static_cast<std::size_t>(grid_.u_count);
  const auto fill = [&](std::int32_t first, std::int32_t last) {
    for (std::int32_t u = first; u < last; ++u) {
      if (raise(row_start + static_cast<std::size_t>(u), limit_mm_)) take_in(changed, u, v);
    }
  };
  const bool touches = wanted.first <= known.last && known.first <= wanted.last;
  if (known.first < known.last && touches) {
    fill(wanted.first, known.first);
    fill(known.last, wanted.last);
    known = {std::min(known.first, wanted.first), std::max(known.last, wanted.last)};
    return;
  }
  fill(wanted.first, wanted.last);
  if (wanted.last - wanted.first > known.last - known.first) known = wanted;
}

void KerfField::stamp(const BladeSize& blade, const PlanarPose& from, const PlanarPose& to,
                      FieldWindow& changed) noexcept {
  changed = {};
  if (!is_finite(from) || !is_finite(to)) return;
  const Hull hull = hull_of(grid_, blade, from, to);
  const double limit_mm = static_cast<double>(limit_mm_);
  // The hull's corners are at least right angles: no offset edge reaches further than 1.42 limits beyond them.
  const std::int32_t v_first =
      clamped_node(std::floor((hull.v_min_mm - 2.0 * limit_mm) / grid_.spacing_mm), grid_.v_count);
  const std::int32_t v_last =
      clamped_node(std::ceil((hull.v_max_mm + 2.0 * limit_mm) / grid_.spacing_mm), grid_.v_count);
  for (std::int32_t v = v_first; v < v_last; ++v) {
    HullRow row(hull, v);
    const RowSpan near = row.deeper_than(-limit_mm, grid_.u_count);
    if (near.first >= near.last) continue;
    const RowSpan deep = HullRow(row).deeper_than(limit_mm, grid_.u_count);
    if (deep.first >= deep.last) {
      row.look_at_middle(near);
      raise_rim(row, near.first, near.last, changed);
      continue;
    }
    raise_rim(row, near.first, deep.first, changed);
    fill_deep(v, deep, changed);
    raise_rim(row, deep.last, near.last, changed);
  }
}

}  // namespace hallux::simulator
