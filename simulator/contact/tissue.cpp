#include "simulator/contact/tissue.h"

#include <cmath>

namespace hallux::simulator {

namespace {

/// Thicker than any bone: without a law all of it is cortical.
constexpr double all_cortical_mm = 1.0e6;

/// By parity where it must be asked: a sawn body's mesh has slivers, near which the sign of its
/// distance can be wrong.
bool is_in_part(const Bvh& part, const Vec3& point_mm, TissueMemory& memory) noexcept {
  const double moved_mm = length_of(point_mm - memory.part_asked_mm);
  if (!memory.knows_part || !(std::abs(memory.part_mm) > moved_mm)) {
    const bool is_inside = part.contains(point_mm);
    const double distance_mm = std::abs(part.signed_distance_mm(point_mm));
    memory.part_mm = is_inside ? -distance_mm : distance_mm;
    memory.part_asked_mm = point_mm;
    memory.knows_part = true;
  }
  return memory.part_mm < 0.0;
}

}  // namespace

TissueMap::TissueMap(const Bone& bone) : outer_(bone.outer), cortex_(bone.cortex) {
  if (!bone.canal.triangles.empty()) canal_.emplace(bone.canal);
}

double TissueMap::clearance_mm(const Vec3& point_in_bone_mm) const noexcept {
  return outer_.signed_distance_mm(point_in_bone_mm);
}

Tissue TissueMap::at(const Vec3& point_in_bone_mm, TissueMemory& memory) const noexcept {
  const double cortex_mm =
      cortex_ ? cortex_thickness_mm(*cortex_, point_in_bone_mm.x) : all_cortical_mm;
  const double moved_mm = length_of(point_in_bone_mm - memory.outer_asked_mm);
  const auto is_settled = [&](double threshold_mm) {
    return std::abs(memory.clearance_mm - threshold_mm) > moved_mm;
  };
  // Outside, in the cortex or below it: only a threshold within the way since the last search calls
  // for another.
  if (!memory.knows_outer || !is_settled(0.0) || !is_settled(-cortex_mm)) {
    memory.clearance_mm = clearance_mm(point_in_bone_mm);
    memory.outer_asked_mm = point_in_bone_mm;
    memory.knows_outer = true;
  }
  if (!(memory.clearance_mm < 0.0)) return Tissue::None;
  if (memory.clearance_mm > -cortex_mm) return Tissue::Cortical;
  return is_marrow(point_in_bone_mm, memory) ? Tissue::Marrow : Tissue::Cancellous;
}

bool TissueMap::is_marrow(const Vec3& point_in_bone_mm, TissueMemory& memory) const noexcept {
  if (!canal_) return false;
  const double moved_mm = length_of(point_in_bone_mm - memory.canal_asked_mm);
  if (!memory.knows_canal || std::abs(memory.canal_mm) <= moved_mm) {
    // The canal's shell faces inward: outside of it, seen as a solid, is the bone around the
    // marrow.
    memory.canal_mm = canal_->signed_distance_mm(point_in_bone_mm);
    memory.canal_asked_mm = point_in_bone_mm;
    memory.knows_canal = true;
  }
  return memory.canal_mm > 0.0;
}

Tissue RemainingTissue::at(const Vec3& point_in_bone_mm, TissueMemory& memory) const noexcept {
  if (kerfs.is_open(point_in_bone_mm)) return Tissue::None;
  if (part != nullptr && !is_in_part(*part, point_in_bone_mm, memory)) return Tissue::None;
  const Tissue tissue = original.at(point_in_bone_mm, memory);
  const bool is_gone = tissue != Tissue::None && remaining().is_taken_out(point_in_bone_mm);
  return is_gone ? Tissue::None : tissue;
}

Tissue RemainingTissue::at(const Vec3& point_in_bone_mm) const noexcept {
  TissueMemory nothing;
  return at(point_in_bone_mm, nothing);
}

}  // namespace hallux::simulator
