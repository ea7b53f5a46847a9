#include "tests/simulator/cutting/worlds/outlines.h"

#include <algorithm>
#include <cmath>

namespace hallux::tests {

using simulator::RegionOutline;

namespace {

double distance_to_segment_mm(const Vec2& point_mm, const Vec2& a_mm, const Vec2& b_mm) {
  const Vec2 way_mm = b_mm - a_mm;
  const double length2 = glm::dot(way_mm, way_mm);
  const double share =
      length2 > 0.0 ? std::clamp(glm::dot(point_mm - a_mm, way_mm) / length2, 0.0, 1.0) : 0.0;
  const Vec2 off_mm = point_mm - (a_mm + share * way_mm);
  return std::sqrt(glm::dot(off_mm, off_mm));
}

}  // namespace

RegionOutline outline_from(const std::vector<LoopCorners>& loops_mm) {
  RegionOutline region;
  for (const LoopCorners& loop_mm : loops_mm) {
    region.corners_mm.insert(region.corners_mm.end(), loop_mm.begin(), loop_mm.end());
    region.loop_ends.push_back(static_cast<std::uint32_t>(region.corners_mm.size()));
  }
  return region;
}

LoopCorners rectangle_loop(const Vec2& min_mm, const Vec2& max_mm) {
  return {min_mm, Vec2(max_mm.x, min_mm.y), max_mm, Vec2(min_mm.x, max_mm.y)};
}

LoopCorners diamond_loop(const Vec2& middle_mm, double reach_mm) {
  return {middle_mm + Vec2(reach_mm, 0.0), middle_mm + Vec2(0.0, reach_mm),
          middle_mm - Vec2(reach_mm, 0.0), middle_mm - Vec2(0.0, reach_mm)};
}

LoopCorners turned_back(LoopCorners loop_mm) {
  std::reverse(loop_mm.begin(), loop_mm.end());
  return loop_mm;
}

RegionOutline rectangle_outline(const Vec2& min_mm, const Vec2& max_mm) {
  return outline_from({rectangle_loop(min_mm, max_mm)});
}

RegionOutline whole_plane() { return rectangle_outline(Vec2(-40.0), Vec2(40.0)); }

bool is_well_inside(const RegionOutline& region, const Vec2& point_mm, double margin_mm) {
  bool is_inside = false;
  std::uint32_t first = 0;
  for (const std::uint32_t end : region.loop_ends) {
    for (std::uint32_t i = first; i < end; ++i) {
      const Vec2& a_mm = region.corners_mm[i];
      const Vec2& b_mm = region.corners_mm[i + 1 < end ? i + 1 : first];
      if (distance_to_segment_mm(point_mm, a_mm, b_mm) < margin_mm) return false;
      if ((a_mm.y > point_mm.y) == (b_mm.y > point_mm.y)) continue;
      const double share = (point_mm.y - a_mm.y) / (b_mm.y - a_mm.y);
      if (a_mm.x + share * (b_mm.x - a_mm.x) > point_mm.x) is_inside = !is_inside;
    }
    first = end;
  }
  return is_inside;
}

}  // namespace hallux::tests
