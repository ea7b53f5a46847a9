#include "tests/screenshots/plane_view.h"

#include <algorithm>
#include <map>
#include <span>

namespace hallux::tests {

using namespace simulator;

namespace {

double turn_of(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Vec2 place_of(const SlabSlice& contact, std::uint32_t point) {
  return place_mm(contact.axes, contact.points[point].point_in_bone_mm);
}

}  // namespace

std::vector<Vec2> PlaneView::pages(const std::vector<Vec2>& places_mm) const {
  std::vector<Vec2> places;
  places.reserve(places_mm.size());
  for (const Vec2& place : places_mm) places.push_back(page(place));
  return places;
}

std::string region_path(const PlaneView& view, const RegionOutline& region) {
  std::string d;
  std::size_t first = 0;
  for (const std::uint32_t end : region.loop_ends) {
    d += path_through(
        view.pages(std::vector<Vec2>(region.corners_mm.begin() + static_cast<std::ptrdiff_t>(first),
                                     region.corners_mm.begin() + static_cast<std::ptrdiff_t>(end))),
        true);
    first = end;
  }
  return d;
}

std::string contour_path(const PlaneView& view, const SlabSlice& contact, int level,
                         std::int32_t kerf) {
  std::string d;
  for (const StripEdge& edge : contact.edges) {
    if (edge.level != level || contact.sources[edge.touched].kerf != kerf) continue;
    d += path_through(view.pages({place_of(contact, edge.a), place_of(contact, edge.b)}), false);
  }
  return d;
}

std::string section_path(const PlaneView& view, const SlabSlice& contact, int level) {
  std::map<std::uint32_t, std::uint32_t> next;
  for (const StripEdge& edge : contact.edges) {
    if (edge.level == level) next[edge.a] = edge.b;
  }
  std::string d;
  while (!next.empty()) {
    std::vector<Vec2> loop_mm;
    for (auto at = next.begin(); at != next.end();) {
      loop_mm.push_back(place_of(contact, at->first));
      const std::uint32_t following = at->second;
      next.erase(at);
      at = next.find(following);
    }
    d += path_through(view.pages(loop_mm), true);
  }
  return d;
}

std::vector<Vec2> blade_corners_mm(const Blade& blade, const PlanarPose& pose) {
  const Vec2 side(-pose.direction.y, pose.direction.x);
  const Vec2 half_mm = 0.5 * blade.width_mm * side, back_mm = -blade.depth_mm * pose.direction;
  const Vec2& tip = pose.tip_mm;
  return {tip - half_mm, tip + half_mm, tip + half_mm + back_mm, tip - half_mm + back_mm};
}

std::vector<Vec2> hull_of(std::vector<Vec2> places_mm) {
  std::sort(places_mm.begin(), places_mm.end(),
            [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull;
  const auto wrap = [&](std::span<const Vec2> along, std::size_t base) {
    for (const Vec2& place : along) {
      while (hull.size() >= base + 2 && turn_of(hull[hull.size() - 2], hull.back(), place) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(place);
    }
    hull.pop_back();
  };
  wrap(places_mm, 0);
  std::reverse(places_mm.begin(), places_mm.end());
  wrap(places_mm, hull.size());
  return hull;
}

}  // namespace hallux::tests
