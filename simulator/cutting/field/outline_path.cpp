// A segment that starts at a corner sees the following grid edges through the gaps between outer
// and inner, like doors of a row of rooms: cells are convex and share the edges, so the points it
// can reach through all doors so far form a cone (the funnel of Lee and Preparata 1984). The
// segment ends at the last crossing itself that lies in the cone, so that straight sides stay where
// they are, unless the cone reaches more than twice as far: then at the last door. The latter is
// how a curve that bends away from the region becomes tangents instead of all its crossings.
#include "simulator/cutting/field/outline_path.h"

namespace hallux::simulator {

namespace {

struct Cone {
  Vec2 apex_mm{0.0, 0.0};
  Vec2 right_mm{0.0, 0.0}, left_mm{0.0, 0.0};  ///< from the apex; the region is on the left
  bool is_open = false;                        ///< no door seen yet: everything is in sight

  bool holds(const Vec2& point_mm) const noexcept {
    const Vec2 way_mm = point_mm - apex_mm;
    return is_open || (cross(right_mm, way_mm) >= 0.0 && cross(left_mm, way_mm) <= 0.0);
  }
  /// Narrows to what passes the door; false where nothing does, and then leaves the cone as it was.
  bool pass(const Crossing& door) noexcept {
    const Vec2 outer_mm = door.outer_mm - apex_mm, inner_mm = door.inner_mm - apex_mm;
    const Vec2 right = is_open || cross(right_mm, outer_mm) > 0.0 ? outer_mm : right_mm;
    const Vec2 left = is_open || cross(left_mm, inner_mm) < 0.0 ? inner_mm : left_mm;
    if (cross(right, left) < 0.0) return false;
    right_mm = right;
    left_mm = left;
    is_open = false;
    return true;
  }
  /// The point in sight of the last door passed that is nearest to its crossing.
  Vec2 point_in(const Crossing& door) const noexcept {
    const Vec2 way_mm = door.at_mm - apex_mm;
    const bool is_right = cross(right_mm, way_mm) < 0.0;
    if (!is_right && cross(left_mm, way_mm) <= 0.0) return door.at_mm;
    const Vec2 ray_mm = is_right ? right_mm : left_mm;
    const Vec2 width_mm = door.inner_mm - door.outer_mm;
    const double per_width = cross(width_mm, ray_mm);
    if (per_width == 0.0) return door.inner_mm;  // seen edge on
    const double part = cross(apex_mm - door.outer_mm, ray_mm) / per_width;
    return door.outer_mm + glm::clamp(part, 0.0, 1.0) * width_mm;
  }
};

struct Segment {
  std::size_t end = 0;  ///< the crossing it ends at
  Vec2 end_mm{0.0, 0.0};
};

/// The longest segment from `start_mm`, a point of the door `start`; the loop's end is its first
/// crossing, exactly.
Segment segment_from(const std::vector<Crossing>& loop, std::size_t start, const Vec2& start_mm) {
  Cone cone{.apex_mm = start_mm, .is_open = true};
  std::size_t landing = start + 1, reached = start;
  for (std::size_t next = start + 1; next <= loop.size(); ++next) {
    const bool is_end = next == loop.size();
    const Crossing& door = loop[is_end ? 0 : next];
    if (cone.holds(door.at_mm)) landing = next;
    if (is_end) break;
    if (!cone.pass(door)) break;
    reached = next;
  }
  if (landing == loop.size()) return {landing, loop[0].at_mm};
  if (reached - start <= 2 * (landing - start)) return {landing, loop[landing].at_mm};
  return {reached, cone.point_in(loop[reached])};
}

}  // namespace

void append_straightened(const std::vector<Crossing>& loop, std::vector<Vec2>& corners_mm) {
  Segment segment{0, loop[0].at_mm};
  while (segment.end < loop.size()) {
    corners_mm.push_back(segment.end_mm);
    segment = segment_from(loop, segment.end, segment.end_mm);
  }
}

}  // namespace hallux::simulator
