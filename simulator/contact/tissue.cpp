#include "simulator/contact/tissue.h"

namespace hallux::simulator {

TissueMap::TissueMap(const Bone& bone) : outer_(bone.outer), cortex_(bone.cortex) {
  if (!bone.canal.triangles.empty()) canal_.emplace(bone.canal);
}

double TissueMap::clearance_mm(const Vec3& point_in_bone_mm) const noexcept {
  return outer_.signed_distance_mm(point_in_bone_mm);
}

Tissue TissueMap::at(const Vec3& point_in_bone_mm) const noexcept {
  const double depth_mm = -clearance_mm(point_in_bone_mm);
  if (!(depth_mm > 0.0)) return Tissue::None;
  if (!cortex_) return Tissue::Cortical;
  if (depth_mm < cortex_thickness_mm(*cortex_, point_in_bone_mm.x)) return Tissue::Cortical;
  // The canal's shell faces inward: outside of it, seen as a solid, is the bone around the marrow.
  if (canal_ && canal_->signed_distance_mm(point_in_bone_mm) > 0.0) return Tissue::Marrow;
  return Tissue::Cancellous;
}

Tissue StandingBone::at(const Vec3& point_in_bone_mm) const noexcept {
  if (kerfs.is_open(point_in_bone_mm)) return Tissue::None;
  const Tissue tissue = original.at(point_in_bone_mm);
  if (tissue == Tissue::None) return tissue;
  for (const Bvh* piece : removed_pieces) {
    if (piece->signed_distance_mm(point_in_bone_mm) < 0.0) return Tissue::None;
  }
  return tissue;
}

}  // namespace hallux::simulator
