#include "scenarios/planned_joints.h"

#include <array>

#include "scenarios/geometry/part_path.h"
#include "simulator/base/elementary.h"

namespace hallux::scenarios {
namespace {

using simulator::IndexedMesh;

bool is_of_surface(const std::array<Vec3, 3>& corner_mm, const Vec3& centre_mm,
                   const JointSurface& surface) {
  if (length_of(simulator::middle_of(corner_mm) - centre_mm) > surface.radius_mm) return false;
  const Vec3 across = glm::cross(corner_mm[1] - corner_mm[0], corner_mm[2] - corner_mm[0]);
  const double size = length_of(across);
  // A sliver has no direction.
  if (!(size > 0.0)) return false;
  return glm::dot(across, surface.facing_in_bone) >= elementary::cos(surface.within_rad) * size;
}

PlannedJointSurface plan_surface(const JointSurface& surface, const Ground& ground,
                                 const std::string& path) {
  const std::size_t bone_index = ground.bone_index(surface.bone);
  const simulator::Bone& bone = ground.bone(bone_index);
  const IndexedMesh& outer = bone.outer;
  const Vec3 centre_mm =
      ground.point(surface.around, bone_index, path + ".around") + surface.offset_in_bone_mm;
  PlannedJointSurface planned{surface.name, surface.title, centre_mm, {}, bone_index};
  for (std::uint32_t index = 0; index < outer.triangles.size(); ++index) {
    if (is_of_surface(simulator::corners_of(outer, index), centre_mm, surface))
      planned.triangles.push_back(index);
  }
  if (!planned.triangles.empty()) return planned;
  throw ScenarioError(path + ": no part of the bone \"" + bone.name +
                      "\" lies there; mend radius_mm, facing_in_bone or within_deg");
}

}  // namespace

std::vector<PlannedJointSurface> plan_joint_surfaces(const Scenario& scenario,
                                                     const Ground& ground) {
  std::vector<PlannedJointSurface> planned;
  for (const JointSurface& surface : scenario.joint_surfaces) {
    planned.push_back(plan_surface(
        surface, ground, part_path(scenario, "joint_surfaces", planned.size(), surface.name)));
  }
  return planned;
}

}  // namespace hallux::scenarios
