/// Which tissue is where: in the bone as it was, and in what of it still stands.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "simulator/cutting/kerf_set.h"
#include "simulator/mesh/bone.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

enum class Tissue : std::uint8_t { None, Marrow, Cancellous, Cortical };

/// The tissues of the original bone. Always asked of the original surface: a cut face is not cortex.
class TissueMap {
 public:
  explicit TissueMap(const Bone& bone);

  /// thread  any; allocates nothing
  Tissue at(const Vec3& point_in_bone_mm) const noexcept;
  /// Distance to the original outer surface, negative inside [mm].
  double clearance_mm(const Vec3& point_in_bone_mm) const noexcept;

 private:
  Bvh outer_;
  std::optional<Bvh> canal_;
  std::optional<CortexLaw> cortex_;
};

/// What still stands: the original bone outside every open kerf and every piece taken out. Borrows all it names.
struct StandingBone {
  const TissueMap& original;
  const KerfSet& kerfs;
  std::span<const Bvh* const> removed_pieces;

  /// thread  haptic; allocates nothing
  Tissue at(const Vec3& point_in_bone_mm) const noexcept;
};

constexpr bool is_bone(Tissue tissue) noexcept {
  return tissue == Tissue::Cancellous || tissue == Tissue::Cortical;
}

}  // namespace hallux::simulator
