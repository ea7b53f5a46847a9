#include "ui/screens/pictures/zones_in_scene.h"

namespace hallux::ui {

std::vector<ZoneInScene> zones_in_scene(const scenarios::Plan& plan,
                                        const RigidTransform& world_from_bone,
                                        const RigidTransform& world_from_tool,
                                        const simulator::Blade& blade) {
  const RigidTransform bone_from_tool = inverse(world_from_bone) * world_from_tool;
  std::vector<ZoneInScene> zones;
  zones.reserve(plan.danger_zones.size());
  for (const scenarios::PlannedZone& planned : plan.danger_zones) {
    const simulator::DangerCapsule& capsule = planned.capsule;
    ZoneInScene zone;
    zone.from_mm = transform_point(world_from_bone, capsule.from_in_bone_mm);
    zone.to_mm = transform_point(world_from_bone, capsule.to_in_bone_mm);
    zone.radius_mm = capsule.radius_mm;
    zone.is_near = distance_to_capsule_mm(bone_from_tool, blade, capsule) < zone_near_mm;
    zone.presence = zone.is_near ? 1.0 : far_zone_presence;
    zones.push_back(zone);
  }
  return zones;
}

}  // namespace hallux::ui
