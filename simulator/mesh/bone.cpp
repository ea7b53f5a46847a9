#include "simulator/mesh/bone.h"

#include "simulator/base/elementary.h"
#include "simulator/mesh/bones.h"

namespace hallux::simulator {

double cortex_thickness_mm(const CortexLaw& law, double x_in_bone_mm) noexcept {
  const double along = (x_in_bone_mm / law.length_mm - 0.5) / 0.22;
  const double thickness_mm = law.mid_mm * (0.35 + 0.65 * elementary::exp(-along * along));
  return thickness_mm > law.floor_mm ? thickness_mm : law.floor_mm;
}

IndexedMesh solid_of(const Bone& bone) {
  IndexedMesh solid = bone.outer;
  append_mesh(solid, bone.canal);
  return solid;
}

RigidTransform first_from(const Bones& bones, std::size_t bone) noexcept {
  if (bone == 0) return {};
  return inverse(bones.first().world_from_bone) * bones[bone].world_from_bone;
}

IndexedMesh outsides_of(const Bones& bones) {
  IndexedMesh all = bones.first().outer;
  for (std::size_t bone = 1; bone < bones.size(); ++bone) {
    const RigidTransform first_from_bone = first_from(bones, bone);
    IndexedMesh lying = bones[bone].outer;
    for (Vec3& point_mm : lying.points_mm) point_mm = transform_point(first_from_bone, point_mm);
    append_mesh(all, lying);
  }
  return all;
}

std::optional<Vec3> find_landmark(const Bone& bone, std::string_view name) {
  for (const Landmark& landmark : bone.landmarks) {
    if (landmark.name == name) return landmark.point_in_bone_mm;
  }
  return std::nullopt;
}

}  // namespace hallux::simulator
