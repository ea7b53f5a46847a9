#include "simulator/mesh/bone.h"

#include "simulator/base/elementary.h"

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

std::optional<Vec3> find_landmark(const Bone& bone, std::string_view name) {
  for (const Landmark& landmark : bone.landmarks) {
    if (landmark.name == name) return landmark.point_in_bone_mm;
  }
  return std::nullopt;
}

}  // namespace hallux::simulator
