/// Along a line of nodes every edge of the hull is a linear function, so where a stamp is above the
/// limit is an interval, and only its two rims need values. What a line has got from earlier stamps
/// is remembered as a cover (line_cover.h): a trembling saw stamps the same lines again and again,
/// and what lies under a cover is passed over without changing a bit.
#include "simulator/cutting/field/swept_blade.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hallux::simulator {

namespace {

/// Poses are whole micrometres and micro-units: a shorter hull edge is noise of rounding, with a
/// direction of its own.
constexpr double shortest_edge_mm = 1.0e-6;
/// Flatter edges count as parallel to the lines: along a whole line they change by less than
/// `flat_change_mm`.
constexpr double flattest_slope = 1.0e-13;
constexpr double flat_change_mm = 1.0e-9;
/// A cover must be this many nodes ahead: its line is no flatter than 1e-5 mm a node, which makes
/// 1e-11 mm, far above the rounding of values near the limit.
constexpr double cover_margin = 1.0e-6;

struct Corner {
  Vec2 at_mm{0.0, 0.0};
  bool is_at_end = false;  ///< of the motion
};

Vec2 side_of(const PlanarPose& pose) noexcept { return {-pose.direction.y, pose.direction.x}; }

void add_rectangle(const Blade& blade, const PlanarPose& pose, bool is_at_end,
                   Corner* corners) noexcept {
  const Vec2 side_mm = 0.5 * blade.width_mm * side_of(pose);
  const Vec2 back_mm = pose.tip_mm - blade.depth_mm * pose.direction;
  corners[0] = {pose.tip_mm - side_mm, is_at_end};
  corners[1] = {pose.tip_mm + side_mm, is_at_end};
  corners[2] = {back_mm - side_mm, is_at_end};
  corners[3] = {back_mm + side_mm, is_at_end};
}

/// Andrew's monotone chain (1979): the hull counter-clockwise, at most eight corners and the first
/// again; returns their count.
std::size_t hull_corners(std::array<Corner, 8>& corners, std::array<Corner, 17>& hull) noexcept {
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return a.at_mm.x < b.at_mm.x || (a.at_mm.x == b.at_mm.x && a.at_mm.y < b.at_mm.y);
  });
  std::size_t count = 0, floor = 2;
  const auto add = [&](const Corner& corner) {
    while (count >= floor && cross(hull[count - 1].at_mm - hull[count - 2].at_mm,
                                   corner.at_mm - hull[count - 2].at_mm) <= 0.0) {
      --count;
    }
    hull[count++] = corner;
  };
  for (const Corner& corner : corners) add(corner);
  floor = count + 1;
  for (std::size_t i = corners.size() - 1; i-- > 0;) add(corners[i]);
  return count - 1;
}

std::int32_t clamped_node(double value, std::int32_t count) noexcept {
  return static_cast<std::int32_t>(std::clamp(value, 0.0, static_cast<double>(count)));
}

}  // namespace

SweptBlade::SweptBlade(const FieldGrid& grid, const Blade& blade, const PlanarPose& from,
                       const PlanarPose& to, double limit_mm) noexcept
    : limit_mm_(limit_mm), v_count_(grid.v_count) {
  std::array<Corner, 8> corners;
  std::array<Corner, 17> hull;
  add_rectangle(blade, from, false, corners.data());
  add_rectangle(blade, to, true, corners.data() + 4);
  const std::size_t corner_count = hull_corners(corners, hull);
  double u_min_mm = std::numeric_limits<double>::infinity(), u_max_mm = -u_min_mm;
  for (std::size_t i = 0; i < corner_count; ++i) {
    const Corner &a = hull[i], &b = hull[i + 1];
    const Vec2 a_mm = a.at_mm - grid.origin_mm;
    u_min_mm = std::min(u_min_mm, a_mm.x);
    u_max_mm = std::max(u_max_mm, a_mm.x);
    add_edge(a_mm, b.at_mm - grid.origin_mm, a.is_at_end && b.is_at_end ? to : from,
             grid.spacing_mm);
  }
  if (count_ < 3) return;  // no area: opens nothing
  sort_edges();
  // Values reach -limit at most two limits beyond the hull: its angles are right ones or wider, and
  // no edge's function is flatter than 1 / 1.42.
  const double margin_mm = 3.0 * limit_mm;
  lines_ = {clamped_node(std::floor((u_min_mm - margin_mm) / grid.spacing_mm), grid.u_count),
            clamped_node(std::ceil((u_max_mm + margin_mm) / grid.spacing_mm), grid.u_count)};
}

void SweptBlade::add_edge(const Vec2& a_mm, const Vec2& b_mm, const PlanarPose& pose,
                          double spacing_mm) noexcept {
  const Vec2 edge_mm = b_mm - a_mm;
  const double length_mm = length_of(edge_mm);
  if (length_mm < shortest_edge_mm) return;
  const Vec2 inward(-edge_mm.y / length_mm, edge_mm.x / length_mm);
  const double corner_share =
      std::abs(glm::dot(inward, pose.direction)) + std::abs(glm::dot(inward, side_of(pose)));
  const Vec2 slope = inward / corner_share;
  along_u_[count_] = slope.x * spacing_mm;
  along_v_[count_] = slope.y * spacing_mm;
  at_origin_[count_] = -(slope.x * a_mm.x + slope.y * a_mm.y);
  ++count_;
}

void SweptBlade::sort_edges() noexcept {
  const auto swap_edges = [&](std::size_t a, std::size_t b) {
    std::swap(along_v_[a], along_v_[b]);
    std::swap(along_u_[a], along_u_[b]);
    std::swap(at_origin_[a], at_origin_[b]);
  };
  for (std::size_t i = 0; i < count_; ++i) {
    if (along_v_[i] > flattest_slope) swap_edges(i, rising_++);
  }
  sloped_ = rising_;
  for (std::size_t i = rising_; i < count_; ++i) {
    if (along_v_[i] < -flattest_slope) swap_edges(i, sloped_++);
  }
  for (std::size_t i = 0; i < sloped_; ++i) nodes_per_mm_[i] = 1.0 / along_v_[i];
}

NodeSpan SweptBlade::span(double first, double last) const noexcept {
  first = std::max(first, 0.0);
  last = std::min(last, static_cast<double>(v_count_) - 1.0);
  if (!(first <= last)) return {};
  // Conversion cuts towards 0, so for numbers from 0 up it rounds down; the bounds lie within the
  // line.
  const auto whole = static_cast<std::int32_t>(first);
  return {static_cast<double>(whole) < first ? whole + 1 : whole,
          static_cast<std::int32_t>(last) + 1};
}

SweptBlade::Line SweptBlade::line(std::int32_t u) const noexcept {
  // The bounds are wrong by rounding, 1e-13 mm; a float's step at the limit is 1e4 times that, so
  // the bits of what is stored do not depend on which side of a bound a node falls.
  Line line;
  for (std::size_t i = 0; i < count_; ++i) {
    line.at_line[i] = along_u_[i] * static_cast<double>(u) + at_origin_[i];
  }
  bound_sloped(line);
  bool is_shallow = false;
  for (std::size_t i = sloped_; i < count_; ++i) {
    if (line.at_line[i] < -limit_mm_ - flat_change_mm) return line;
    if (line.at_line[i] >= limit_mm_ + flat_change_mm) continue;
    is_shallow = true;
    line.rising_edge = line.falling_edge = i;
  }
  line.near = span(line.bounds.low_near, line.bounds.high_near);
  if (!is_shallow) line.deep = span(line.bounds.low_deep, line.bounds.high_deep);
  if (line.deep.is_empty()) line.deep = {line.near.last, line.near.last};
  return line;
}

void SweptBlade::bound_sloped(Line& line) const noexcept {
  LineCover& bounds = line.bounds;
  bounds.low_near = bounds.low_deep = 0.0;
  bounds.high_near = bounds.high_deep = static_cast<double>(v_count_) - 1.0;
  for (std::size_t i = 0; i < rising_; ++i) {
    const double near = (-limit_mm_ - line.at_line[i]) * nodes_per_mm_[i];
    const double deep = (limit_mm_ - line.at_line[i]) * nodes_per_mm_[i];
    bounds.low_near = std::max(bounds.low_near, near);
    if (deep <= bounds.low_deep) continue;
    bounds.low_deep = deep;
    line.rising_edge = i;
  }
  for (std::size_t i = rising_; i < sloped_; ++i) {
    const double near = (-limit_mm_ - line.at_line[i]) * nodes_per_mm_[i];
    const double deep = (limit_mm_ - line.at_line[i]) * nodes_per_mm_[i];
    bounds.high_near = std::min(bounds.high_near, near);
    if (deep >= bounds.high_deep) continue;
    bounds.high_deep = deep;
    line.falling_edge = i;
  }
  bounds.low_end = bounds.high_deep;
  bounds.high_end = bounds.low_deep;
}

bool SweptBlade::covers_low(std::size_t edge, double at_line_mm,
                            const LineCover& cover) const noexcept {
  const double near = (-limit_mm_ - at_line_mm) * nodes_per_mm_[edge];
  const double deep = (limit_mm_ - at_line_mm) * nodes_per_mm_[edge];
  return near > cover.low_near + cover_margin && deep > cover.low_deep + cover_margin &&
         deep <= cover.low_end;
}

bool SweptBlade::covers_high(std::size_t edge, double at_line_mm,
                             const LineCover& cover) const noexcept {
  const double near = (-limit_mm_ - at_line_mm) * nodes_per_mm_[edge];
  const double deep = (limit_mm_ - at_line_mm) * nodes_per_mm_[edge];
  return near < cover.high_near - cover_margin && deep < cover.high_deep - cover_margin &&
         deep >= cover.high_end;
}

bool SweptBlade::is_covered(std::int32_t u, const LineCover& cover) const noexcept {
  if (cover.high_end > cover.low_end) return false;  // between the two sides nothing is known
  const auto at_line_mm = [&](std::size_t edge) {
    return along_u_[edge] * static_cast<double>(u) + at_origin_[edge];
  };
  std::size_t rising = 0, falling = rising_;
  while (rising < rising_ && !covers_low(rising, at_line_mm(rising), cover)) ++rising;
  if (rising == rising_) return false;
  while (falling < sloped_ && !covers_high(falling, at_line_mm(falling), cover)) ++falling;
  return falling < sloped_;
}

bool SweptBlade::is_low_covered(const Line& line, const LineCover& cover) const noexcept {
  return line.rising_edge < rising_ &&
         covers_low(line.rising_edge, line.at_line[line.rising_edge], cover);
}

bool SweptBlade::is_high_covered(const Line& line, const LineCover& cover) const noexcept {
  return line.falling_edge >= rising_ && line.falling_edge < sloped_ &&
         covers_high(line.falling_edge, line.at_line[line.falling_edge], cover);
}

double SweptBlade::inside_mm(const Line& line, std::int32_t v) const noexcept {
  double inside_mm = edge_mm(line, 0, v);
  for (std::size_t i = 1; i < count_; ++i) inside_mm = std::min(inside_mm, edge_mm(line, i, v));
  return inside_mm;
}

}  // namespace hallux::simulator
