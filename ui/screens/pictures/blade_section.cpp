// The plane of the blade as plain polygons. The kernel's section gives the bone, the kerf's outline
// what is open; the rest is cut here: planned faces give lines, capsules give hulls of the circles
// along their axes, which is exact but for the number of circles.
#include "ui/screens/pictures/blade_section.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"
#include "simulator/contact/danger_zone.h"
#include "ui/screens/pictures/section_rows.h"
#include "ui/screens/pictures/zones_in_scene.h"

namespace hallux::ui {

namespace {

/// A face that is nearly the plane itself crosses it nowhere that means anything.
constexpr double parallel_rad = 0.09;
/// How far traces are drawn beyond the bone.
constexpr double beyond_mm = 5.0;
constexpr double same_plane_mm = 1.2, same_plane_rad = 0.06;
constexpr int circles = 24, circle_corners = 20;
constexpr int teeth_asked = 25;

struct Bounds {
  Vec2 low_mm{1.0e9, 1.0e9}, high_mm{-1.0e9, -1.0e9};

  bool is_empty() const noexcept { return low_mm.x > high_mm.x; }
};

Bounds bounds_of(const std::vector<PlaneLoop>& loops) {
  Bounds bounds;
  for (const PlaneLoop& loop : loops) {
    for (const Vec2& corner : loop) {
      bounds.low_mm = glm::min(bounds.low_mm, corner);
      bounds.high_mm = glm::max(bounds.high_mm, corner);
    }
  }
  return bounds;
}

double cross(const Vec2& a, const Vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

/// The part of the line through `place` within the bounds, widened; nothing where it misses them.
std::optional<PlanTrace> clipped(PlanTraceKind kind, const Vec2& place, const Vec2& direction,
                                 const Bounds& bounds) {
  double from = -1.0e9, to = 1.0e9;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = bounds.low_mm[axis] - beyond_mm, high = bounds.high_mm[axis] + beyond_mm;
    if (std::abs(direction[axis]) < 1.0e-9) {
      if (place[axis] < low || place[axis] > high) return std::nullopt;
      continue;
    }
    const double a = (low - place[axis]) / direction[axis];
    const double b = (high - place[axis]) / direction[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (from >= to) return std::nullopt;
  return PlanTrace{kind, place + from * direction, place + to * direction};
}

std::optional<PlanTrace> trace_of(const scenarios::PlannedCut& cut, const RigidTransform& plane,
                                  const Bounds& bounds) {
  const Vec3 normal = transform_direction(inverse(plane), cut.face.normal);
  const Vec2 across(normal.x, normal.y);
  const double steepness = glm::length(across);
  if (steepness < std::sin(parallel_rad)) return std::nullopt;
  const double offset_mm = cut.face.offset_mm - glm::dot(cut.face.normal, plane.translation_mm);
  const Vec2 unit = across / steepness;
  return clipped(PlanTraceKind::Face, offset_mm / steepness * unit, Vec2(-unit.y, unit.x), bounds);
}

std::optional<PlanTrace> trace_of(const scenarios::PlannedHinge& hinge, const RigidTransform& plane,
                                  const Bounds& bounds) {
  const RigidTransform plane_from_bone = inverse(plane);
  const Vec3 place = transform_point(plane_from_bone, hinge.bridge.line.point_in_bone_mm);
  const Vec3 axis = transform_direction(plane_from_bone, hinge.bridge.line.axis);
  const Vec2 along(axis.x, axis.y);
  const double length = glm::length(along);
  if (length < 0.5) return std::nullopt;
  return clipped(PlanTraceKind::Hinge, Vec2(place.x, place.y), along / length, bounds);
}

std::vector<PlanTrace> traces_of(const scenarios::Plan& plan, const RigidTransform& plane,
                                 const Bounds& bounds) {
  std::vector<PlanTrace> traces;
  if (bounds.is_empty()) return traces;
  const auto add = [&](const std::optional<PlanTrace>& trace) {
    if (trace) traces.push_back(*trace);
  };
  for (const scenarios::PlannedCut& cut : plan.cuts) add(trace_of(cut, plane, bounds));
  for (const scenarios::PlannedHinge& hinge : plan.hinges) add(trace_of(hinge, plane, bounds));
  return traces;
}

/// source  Andrew 1979, Another efficient algorithm for convex hulls in two dimensions
PlaneLoop hull_of(std::vector<Vec2> points) {
  std::ranges::sort(
      points, [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  PlaneLoop hull;
  const auto add_side = [&hull](auto first, auto last) {
    const std::size_t kept = hull.size();
    for (auto point = first; point != last; ++point) {
      while (hull.size() >= kept + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*point);
    }
    if (!hull.empty()) hull.pop_back();
  };
  add_side(points.begin(), points.end());
  add_side(points.rbegin(), points.rend());
  return hull;
}

PlaneLoop outline_of(const simulator::DangerCapsule& capsule, const RigidTransform& plane) {
  const RigidTransform plane_from_bone = inverse(plane);
  const Vec3 from = transform_point(plane_from_bone, capsule.from_in_bone_mm);
  const Vec3 to = transform_point(plane_from_bone, capsule.to_in_bone_mm);
  std::vector<Vec2> points;
  for (int i = 0; i <= circles; ++i) {
    const double share = static_cast<double>(i) / circles;
    const Vec3 middle = from + share * (to - from);
    const double square = capsule.radius_mm * capsule.radius_mm - middle.z * middle.z;
    if (square <= 0.0) continue;
    for (int corner = 0; corner < circle_corners; ++corner) {
      const double angle = 2.0 * pi * corner / circle_corners;
      points.push_back(Vec2(middle.x, middle.y) +
                       std::sqrt(square) * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  if (points.size() < 3) return {};
  return hull_of(std::move(points));
}

std::vector<ZoneInSection> zones_of(const scenarios::Plan& plan, const RigidTransform& plane,
                                    const RigidTransform& bone_from_tool,
                                    const simulator::Blade& blade) {
  std::vector<ZoneInSection> zones;
  for (const scenarios::PlannedZone& planned : plan.danger_zones) {
    ZoneInSection zone;
    zone.name = planned.name;
    zone.outline_mm = outline_of(planned.capsule, plane);
    zone.distance_mm = distance_to_capsule_mm(bone_from_tool, blade, planned.capsule);
    zone.is_near = zone.distance_mm < zone_near_mm;
    zones.push_back(std::move(zone));
  }
  return zones;
}

Vec2 normal_of(const Vec2& feed) noexcept { return Vec2(-feed.y, feed.x); }

/// With the feed as y, so that a row runs along it.
std::vector<PlaneLoop> turned(std::vector<PlaneLoop> loops, const Vec2& feed) {
  const Vec2 across = normal_of(feed);
  for (PlaneLoop& loop : loops) {
    for (Vec2& corner : loop) corner = Vec2(glm::dot(across, corner), glm::dot(feed, corner));
  }
  return loops;
}

/// Takes a stretch of standing bone along a tooth's way into account.
void look_at(simulator::BladeAhead& ahead, double from_mm, double to_mm) {
  if (to_mm <= 0.0) return;
  const double first_mm = std::max(0.0, from_mm);
  ahead.to_bone_mm = std::min(ahead.to_bone_mm.value_or(first_mm), first_mm);
  ahead.to_far_side_mm = std::max(ahead.to_far_side_mm.value_or(to_mm), to_mm);
}

}  // namespace

bool is_hole(const PlaneLoop& loop) {
  double doubled_area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    doubled_area += cross(loop[i], loop[(i + 1) % loop.size()]);
  }
  return doubled_area <= 0.0;
}

KerfSection kerf_section(const simulator::CutSolid& solid, const simulator::Bvh& tree,
                         const simulator::KerfOpening& kerf) {
  KerfSection made{kerf.plane.bone_from_kerf, {}, kerf.opened_mm};
  const simulator::Section section = slice_section(solid, tree, kerf.plane);
  for (const simulator::SectionRegion& region : section.regions) {
    made.bone_mm.insert(made.bone_mm.end(), region.contours.begin(), region.contours.end());
  }
  return made;
}

bool is_in_plane(const RigidTransform& bone_from_plane,
                 const RigidTransform& bone_from_tool) noexcept {
  const RigidTransform plane_from_tool = inverse(bone_from_plane) * bone_from_tool;
  const Vec3 normal = plane_from_tool.rotation * Vec3(0.0, 0.0, 1.0);
  return std::abs(plane_from_tool.translation_mm.z) < same_plane_mm &&
         std::abs(normal.z) > std::cos(same_plane_rad);
}

simulator::BladeAhead ahead_in(const BladeSection& section) {
  const Vec2 along = section.teeth_to_mm - section.teeth_from_mm, across = normal_of(section.feed);
  const std::vector<PlaneLoop> bone = turned(section.section.bone_mm, section.feed),
                               opened = turned(section.section.opened_mm, section.feed);
  simulator::BladeAhead ahead;
  for (int tooth = 0; tooth < teeth_asked; ++tooth) {
    const double share = (static_cast<double>(tooth) + 0.5) / teeth_asked;
    const Vec2 tooth_mm = section.teeth_from_mm + share * along;
    const double row_mm = glm::dot(across, tooth_mm), at_mm = glm::dot(section.feed, tooth_mm);
    for (const RowSpan& stands : without(spans_at(bone, row_mm), spans_at(opened, row_mm)))
      look_at(ahead, stands.from_mm - at_mm, stands.to_mm - at_mm);
  }
  return ahead;
}

BladeSection blade_section(const KerfSection& section, const RigidTransform& bone_from_tool,
                           const simulator::Blade& blade, const scenarios::Plan* plan) {
  const RigidTransform plane_from_tool = inverse(section.bone_from_plane) * bone_from_tool;
  const auto in_plane = [](const Vec3& vector) { return Vec2(vector.x, vector.y); };
  const double half_mm = 0.5 * blade.width_mm;
  BladeSection made;
  made.section = section;
  made.teeth_from_mm = in_plane(transform_point(plane_from_tool, Vec3(0.0, -half_mm, 0.0)));
  made.teeth_to_mm = in_plane(transform_point(plane_from_tool, Vec3(0.0, half_mm, 0.0)));
  const Vec2 feed = in_plane(transform_direction(plane_from_tool, Vec3(1.0, 0.0, 0.0)));
  if (glm::length(feed) > 1.0e-3) made.feed = glm::normalize(feed);
  made.blade_depth_mm = blade.depth_mm;
  if (plan == nullptr) return made;
  made.plan = traces_of(*plan, section.bone_from_plane, bounds_of(section.bone_mm));
  made.zones = zones_of(*plan, section.bone_from_plane, bone_from_tool, blade);
  return made;
}

}  // namespace hallux::ui
