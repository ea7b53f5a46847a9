#include "ui/sight/sight_samples.h"

#include <algorithm>
#include <cmath>

namespace hallux::ui {

namespace {

using simulator::Contour;

constexpr double tooth_step_mm = 1.0, mouth_step_mm = 0.5;
/// Beyond one that was found.
constexpr double past_surface_mm = 0.01;
/// Off the steel, off the rim.
constexpr double beside_mm = 0.1;
/// Cosine between the skin and the way against the feed, from which on it is the blade's side.
constexpr double facing = 0.1;

bool is_open(const std::vector<Contour>& opened_mm, const Vec2& place_mm) {
  bool is_inside = false;
  for (const Contour& loop : opened_mm) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a.y > place_mm.y) == (b.y > place_mm.y)) continue;
      const double x_mm = a.x + (place_mm.y - a.y) / (b.y - a.y) * (b.x - a.x);
      if (x_mm > place_mm.x) is_inside = !is_inside;
    }
  }
  return is_inside;
}

bool is_hole(const Contour& loop) {
  double doubled_area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    doubled_area += a.x * b.y - a.y * b.x;
  }
  return doubled_area <= 0.0;
}

/// Adds the open places of one edge of the bone's outline, which runs counter-clockwise.
void add_mouth(std::vector<SightPlace>& places, const RigidTransform& world_from_kerf,
               const simulator::KerfOpening& kerf, const Vec2& a, const Vec2& b) {
  const double length_mm = glm::distance(a, b);
  if (length_mm <= 0.0) return;
  const Vec2 outward = Vec2(b.y - a.y, a.x - b.x) / length_mm;
  if (-outward.x < facing) return;
  const int count = std::max(1, static_cast<int>(std::lround(length_mm / mouth_step_mm)));
  const double half_mm = 0.5 * kerf.plane.thickness_mm + beside_mm;
  for (int i = 0; i < count; ++i) {
    const Vec2 place_mm = a + (i + 0.5) / count * (b - a);
    // A little into the bone: on its very outline rounding decides.
    if (!is_open(kerf.opened_mm, place_mm - beside_mm * outward)) continue;
    places.push_back({transform_point(world_from_kerf, Vec3(place_mm, half_mm)),
                      transform_point(world_from_kerf, Vec3(place_mm, -half_mm))});
  }
}

/// To the last surface of the bone that the blade passes through behind the tooth; 0 where it
/// passes through none.
double way_back_mm(const WholeBone& bone, const Vec3& tooth_mm, const Vec3& back, double reach_mm) {
  double way_mm = 0.0;
  for (double from_mm = 0.0; from_mm < reach_mm;) {
    const auto hit = bone.tree.first_hit(tooth_mm + from_mm * back, back);
    if (!hit || from_mm + hit->distance_mm > reach_mm) break;
    way_mm = from_mm + hit->distance_mm;
    from_mm = way_mm + past_surface_mm;
  }
  return way_mm;
}

}  // namespace

std::vector<SightPlace> tooth_places(const WholeBone& bone, const RigidTransform& world_from_tool,
                                     const simulator::Blade& blade) {
  const RigidTransform bone_from_tool = inverse(bone.world_from_bone) * world_from_tool;
  const Vec3 back = transform_direction(bone_from_tool, Vec3(-1.0, 0.0, 0.0));
  const Vec3 aside = (0.5 * blade.thickness_mm + beside_mm) *
                     transform_direction(bone_from_tool, Vec3(0.0, 0.0, 1.0));
  const int count = std::max(2, static_cast<int>(std::lround(blade.width_mm / tooth_step_mm)));
  std::vector<SightPlace> places;
  for (int i = 0; i < count; ++i) {
    const double along_mm = blade.width_mm * ((i + 0.5) / count - 0.5);
    Vec3 place_mm = transform_point(bone_from_tool, Vec3(0.0, along_mm, 0.0));
    place_mm += way_back_mm(bone, place_mm, back, blade.depth_mm) * back;
    places.push_back({transform_point(bone.world_from_bone, place_mm + aside),
                      transform_point(bone.world_from_bone, place_mm - aside)});
  }
  return places;
}

std::vector<SightPlace> mouth_places(const WholeBone& bone, const simulator::KerfOpening& kerf) {
  const RigidTransform world_from_kerf = bone.world_from_bone * kerf.plane.bone_from_kerf;
  std::vector<SightPlace> places;
  for (const simulator::SectionRegion& region :
       slice_section(bone.solid, bone.tree, kerf.plane).regions) {
    for (const Contour& contour : region.contours) {
      if (is_hole(contour)) continue;  // a canal is no mouth
      for (std::size_t i = 0; i < contour.size(); ++i) {
        add_mouth(places, world_from_kerf, kerf, contour[i], contour[(i + 1) % contour.size()]);
      }
    }
  }
  return places;
}

}  // namespace hallux::ui
