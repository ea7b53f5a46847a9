/// Which tissue is where: in the bone as it was, and in what of it still stands.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "simulator/contact/surface_memory.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/cutting/remaining/remaining_bone.h"
#include "simulator/mesh/bone.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

enum class Tissue : std::uint8_t { None, Marrow, Cancellous, Cortical };

/// What was asked near a point before: distances change by no more than the way since, so most
/// answers need no search. Part of the state of whoever asks; the answers are the same without it.
struct TissueMemory {
  /// Of the canal's wall the clearance is above 0 in the marrow.
  SurfaceMemory outer, canal, part;
};

/// The tissues of the original bone. Always asked of the original surface: a cut face is not
/// cortex.
class TissueMap {
 public:
  explicit TissueMap(const Bone& bone);

  /// thread  any; allocates nothing
  Tissue at(const Vec3& point_in_bone_mm) const noexcept {
    TissueMemory nothing;
    return at(point_in_bone_mm, nothing);
  }
  Tissue at(const Vec3& point_in_bone_mm, TissueMemory& memory) const noexcept;
  /// Distance to the original outer surface, negative inside [mm].
  double clearance_mm(const Vec3& point_in_bone_mm) const noexcept;
  /// The original outer surface.
  const Bvh& surface() const noexcept { return outer_; }

 private:
  bool is_marrow(const Vec3& point_in_bone_mm, SurfaceMemory& memory) const noexcept;

  Bvh outer_;
  std::optional<Bvh> canal_;
  std::optional<CortexLaw> cortex_;
};

/// What still stands of one fragment: the original bone, or the part of it that the fragment is,
/// outside every open kerf and every piece taken out. Borrows all it names.
struct RemainingTissue {
  const TissueMap& original;
  FragmentKerfs kerfs;
  std::span<const Bvh* const> removed_pieces;
  /// Null where the fragment is all of the original.
  const Bvh* part = nullptr;

  /// thread  haptic; allocates nothing
  Tissue at(const Vec3& point_in_bone_mm) const noexcept;
  Tissue at(const Vec3& point_in_bone_mm, TissueMemory& memory) const noexcept;
  /// The outer surface as it was before these kerfs.
  const Bvh& surface() const noexcept { return part == nullptr ? original.surface() : *part; }
  /// Distance to that surface, negative inside [mm].
  double clearance_mm(const Vec3& point_in_bone_mm) const noexcept {
    return surface().signed_distance_mm(point_in_bone_mm);
  }
  /// The same bone for questions about its surface.
  RemainingBone remaining() const noexcept { return {surface(), kerfs, removed_pieces}; }
};

constexpr bool is_bone(Tissue tissue) noexcept {
  return tissue == Tissue::Cancellous || tissue == Tissue::Cortical;
}

}  // namespace hallux::simulator
