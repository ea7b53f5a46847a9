/// Ways are tried, not solved for: from eight sides across the bone, with the teeth along it or
/// across, to five points of the zone. The blade in the zone lies where it went through on its last
/// 20 to 30 mm, so its distance from bone is the way's.
#include "scenarios/hands/zone_touch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "simulator/mesh/bvh.h"

namespace hallux::scenarios {

namespace {

/// So deep are the teeth in the zone, and so much air is left beside the blade.
constexpr double bite_mm = 0.5, room_min_mm = 1.0;
constexpr int sides = 8, points = 5, samples = 5;
/// Between feeds that are further apart the straight way would lead through the bone.
constexpr double straight_cosine_min = -0.2;

/// Feeds across the bone: x is along it in every bone's frame.
Vec3 feed_from(int side) {
  const double diagonal = std::sqrt(0.5);
  const std::array<Vec2, sides> directions{{{-1.0, 0.0},
                                            {-diagonal, diagonal},
                                            {0.0, 1.0},
                                            {diagonal, diagonal},
                                            {1.0, 0.0},
                                            {diagonal, -diagonal},
                                            {0.0, -1.0},
                                            {-diagonal, -diagonal}}};
  const Vec2& direction = directions[static_cast<std::size_t>(side)];
  return {0.0, direction.x, direction.y};
}

/// The blade from there, turned over as little as can be.
RigidTransform blade_at(const Vec3& feed, const Vec3& teeth, const Vec3& tip_in_bone_mm,
                        const Vec3& home_normal) {
  const double sign = glm::dot(glm::cross(feed, teeth), home_normal) < 0.0 ? -1.0 : 1.0;
  return {rotation_from_axes(feed, sign * teeth), tip_in_bone_mm};
}

using Zones = std::vector<simulator::DangerCapsule>;

double room_mm(const RigidTransform& bone_from_blade, const simulator::Bvh& bones,
               const Zones& zones, const simulator::Blade& blade, std::size_t touched) {
  double least_mm = std::numeric_limits<double>::infinity();
  const double step_y_mm = blade.width_mm / (samples - 1);
  for (double x_mm = 0.0; x_mm <= blade.depth_mm; x_mm += 0.25 * step_y_mm) {
    for (int i = 0; i < samples; ++i) {
      const Vec3 point =
          transform_point(bone_from_blade, Vec3{-x_mm, -0.5 * blade.width_mm + i * step_y_mm, 0.0});
      least_mm = std::min(least_mm, bones.signed_distance_mm(point));
    }
  }
  least_mm -= 0.5 * blade.kerf_mm;
  for (std::size_t zone = 0; zone < zones.size(); ++zone) {
    if (zone == touched) continue;
    least_mm = std::min(least_mm, distance_to_capsule_mm(bone_from_blade, blade, zones[zone]));
  }
  return least_mm;
}

std::size_t index_of_zone(const Plan& plan, const std::string& name) {
  for (std::size_t zone = 0; zone < plan.danger_zones.size(); ++zone) {
    if (plan.danger_zones[zone].name == name) return zone;
  }
  throw ScenarioError("the plan has no danger zone \"" + name + "\" to be touched");
}

/// Whether a way is to be taken rather than the best so far.
bool is_better(const ZoneTouch& way, const ZoneTouch& best, const Vec3& home_feed) {
  const bool is_free = way.room_mm >= room_min_mm, was_free = best.room_mm >= room_min_mm;
  if (is_free != was_free) return is_free;
  const double alike = glm::dot(axis_x(way.bone_from_blade), home_feed);
  const double was_alike = glm::dot(axis_x(best.bone_from_blade), home_feed);
  // Sides are 45 degrees apart: what differs by less is rounding.
  if (is_free && std::abs(alike - was_alike) > 0.1) return alike > was_alike;
  return way.room_mm > best.room_mm;
}

/// From a side between the two; from opposite ones there is a choice: medial, or dorsal.
std::optional<RigidTransform> halfway(const RigidTransform& home, const RigidTransform& there) {
  const Vec3 from = axis_x(home), to = axis_x(there);
  if (glm::dot(from, to) >= straight_cosine_min) return std::nullopt;
  Vec3 between = from + to;
  if (length_of(between) < 0.3) {
    const Vec3 medial{0.0, 0.0, 1.0}, dorsal{0.0, -1.0, 0.0};
    const Vec3& side = std::abs(glm::dot(from, medial)) < 0.7 ? medial : dorsal;
    between = side - glm::dot(side, from) * from;
  }
  const Vec3 feed = between / length_of(between);
  const Vec3 along{1.0, 0.0, 0.0};
  return blade_at(feed, along - glm::dot(along, feed) * feed, there.translation_mm, axis_z(home));
}

}  // namespace

ZoneTouch plan_touch(const simulator::Bones& bones, const Plan& plan, const simulator::Blade& blade,
                     const ZoneTask& task) {
  const Zones zones = capsules_of(plan.danger_zones, bones);
  const std::size_t touched = index_of_zone(plan, task.zone);
  const simulator::DangerCapsule& zone = zones[touched];
  const simulator::Bvh outer(outsides_of(bones));
  const Vec3 home_feed = axis_x(task.bone_from_home), home_normal = axis_z(task.bone_from_home);
  const Vec3 along{1.0, 0.0, 0.0};
  ZoneTouch best{.room_mm = -std::numeric_limits<double>::infinity()};
  for (int side = 0; side < sides; ++side) {
    const Vec3 feed = feed_from(side);
    for (const Vec3& teeth : {along, glm::cross(feed, along)}) {
      for (int i = 0; i < points; ++i) {
        const double share = static_cast<double>(i) / (points - 1);
        const Vec3 middle =
            zone.from_in_bone_mm + share * (zone.to_in_bone_mm - zone.from_in_bone_mm);
        const Vec3 tip = middle - std::max(0.0, zone.radius_mm - bite_mm) * feed;
        ZoneTouch way{.bone_from_blade = blade_at(feed, teeth, tip, home_normal)};
        way.room_mm = room_mm(way.bone_from_blade, outer, zones, blade, touched);
        if (is_better(way, best, home_feed)) best = way;
      }
    }
  }
  best.bone_from_halfway = halfway(task.bone_from_home, best.bone_from_blade);
  return best;
}

}  // namespace hallux::scenarios
