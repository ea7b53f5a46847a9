#include "scenarios/planned_zones.h"

#include <algorithm>

#include "scenarios/geometry/part_path.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;
using simulator::DangerCapsule;

/// The deepest blades of the forefoot reach half of this.
constexpr double far_mm = 60.0;

/// Counted along the bone's axes from a landmark, or from the bone's origin.
Vec3 end_of(const Ground& ground, std::size_t bone, const std::string& landmark,
            const Vec3& offset_mm, const std::string& path) {
  if (landmark.empty()) return offset_mm;
  return ground.point(landmark, bone, path) + offset_mm;
}

double distance_to_line_mm(const Vec3& point_mm, const DangerCapsule& capsule) {
  const Vec3 along = capsule.to_in_bone_mm - capsule.from_in_bone_mm;
  const double length_mm2 = glm::dot(along, along);
  const Vec3 way = point_mm - capsule.from_in_bone_mm;
  const double share =
      length_mm2 > 0.0 ? std::clamp(glm::dot(way, along) / length_mm2, 0.0, 1.0) : 0.0;
  return length_of(way - share * along);
}

bool is_near(const Bone& bone, const DangerCapsule& capsule) {
  return std::any_of(bone.outer.points_mm.begin(), bone.outer.points_mm.end(),
                     [&](const Vec3& point) {
                       return distance_to_line_mm(point, capsule) <= far_mm + capsule.radius_mm;
                     });
}

}  // namespace

std::vector<PlannedZone> plan_zones(const Scenario& scenario, const Ground& ground) {
  std::vector<PlannedZone> zones;
  for (const DangerZone& zone : scenario.danger_zones) {
    const std::string path = part_path(scenario, "danger_zones", zones.size(), zone.name);
    const std::size_t index = ground.bone_index(zone.bone);
    const Bone& bone = ground.bone(index);
    const DangerCapsule capsule{
        end_of(ground, index, zone.from_landmark, zone.from_in_bone_mm, path),
        end_of(ground, index, zone.to_landmark, zone.to_in_bone_mm, path), zone.radius_mm};
    if (!is_near(bone, capsule)) {
      throw ScenarioError(path + ": it lies more than 60 mm from the bone \"" + bone.name +
                          "\", where no blade comes; mend from_in_bone_mm and to_in_bone_mm");
    }
    zones.push_back({zone.name, capsule, index});
  }
  return zones;
}

std::vector<DangerCapsule> capsules_of(const std::vector<PlannedZone>& zones,
                                       const simulator::Bones& bones) {
  std::vector<DangerCapsule> capsules;
  for (const PlannedZone& zone : zones) {
    DangerCapsule& capsule = capsules.emplace_back(zone.capsule);
    if (zone.bone == 0) continue;
    const RigidTransform first_from_bone = first_from(bones, zone.bone);
    for (Vec3* const end_mm : {&capsule.from_in_bone_mm, &capsule.to_in_bone_mm})
      *end_mm = transform_point(first_from_bone, *end_mm);
  }
  return capsules;
}

}  // namespace hallux::scenarios
