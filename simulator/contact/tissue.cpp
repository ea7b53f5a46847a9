#include "simulator/contact/tissue.h"

#include <cmath>

namespace hallux::simulator {

namespace {

/// Thicker than any bone: without a law all of it is cortical.
constexpr double all_cortical_mm = 1.0e6;

/// By parity where it must be asked: a sawn body's mesh has slivers, near which the sign of its
/// distance can be wrong.
bool is_in_part(const Bvh& part, const Vec3& point_mm, SurfaceMemory& memory) noexcept {
  if (memory.is_known && std::abs(memory.clearance_mm) > memory.moved_mm(point_mm))
    return memory.clearance_mm < 0.0;
  const double outside_mm = part.outside_box_mm(point_mm);
  if (outside_mm > 0.0) {
    memory = {point_mm, outside_mm, true};
    return false;
  }
  const bool is_inside = part.contains(point_mm);
  const double distance_mm = std::abs(clearance_by_memory(part, point_mm, memory));
  memory = {point_mm, is_inside ? -distance_mm : distance_mm, true};
  return is_inside && distance_mm > 0.0;
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
  SurfaceMemory& outer = memory.outer;
  const double moved_mm = outer.moved_mm(point_in_bone_mm);
  const auto is_settled = [&](double threshold_mm) {
    return std::abs(outer.clearance_mm - threshold_mm) > moved_mm;
  };
  // Outside, in the cortex or below it: only a threshold within the way since the last search calls
  // for another.
  if (!outer.is_known || !is_settled(0.0) || !is_settled(-cortex_mm))
    outer = {point_in_bone_mm, clearance_by_memory(outer_, point_in_bone_mm, outer), true};
  if (!(outer.clearance_mm < 0.0)) return Tissue::None;
  if (outer.clearance_mm > -cortex_mm) return Tissue::Cortical;
  return is_marrow(point_in_bone_mm, memory.canal) ? Tissue::Marrow : Tissue::Cancellous;
}

bool TissueMap::is_marrow(const Vec3& point_in_bone_mm, SurfaceMemory& memory) const noexcept {
  if (!canal_) return false;
  if (!memory.is_known || std::abs(memory.clearance_mm) <= memory.moved_mm(point_in_bone_mm)) {
    // The canal's shell faces inward: outside of it, seen as a solid, is the bone around the
    // marrow.
    memory = {point_in_bone_mm, clearance_by_memory(*canal_, point_in_bone_mm, memory), true};
  }
  return memory.clearance_mm > 0.0;
}

Tissue RemainingTissue::at(const Vec3& point_in_bone_mm, TissueMemory& memory) const noexcept {
  if (part != nullptr && !is_in_part(*part, point_in_bone_mm, memory.part)) return Tissue::None;
  if (kerfs.is_open(point_in_bone_mm)) return Tissue::None;
  const Tissue tissue = original.at(point_in_bone_mm, memory);
  const bool is_gone = tissue != Tissue::None && remaining().is_taken_out(point_in_bone_mm);
  return is_gone ? Tissue::None : tissue;
}

Tissue RemainingTissue::at(const Vec3& point_in_bone_mm) const noexcept {
  TissueMemory nothing;
  return at(point_in_bone_mm, nothing);
}

}  // namespace hallux::simulator
