/// How a bone looks beyond its shape: how deep each point lies, so that cut faces show their
/// cortex; computed once a bone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/mesh/bone.h"

namespace hallux::ui {

/// Depth below the bone's outer surface on a lattice of its frame, x running fastest.
struct DepthVolume {
  /// Of node (0, 0, 0).
  Vec3 origin_in_bone_mm{0.0, 0.0, 0.0};
  double spacing_mm = 0.75;
  std::uint32_t x_count = 0, y_count = 0, z_count = 0;
  /// Depth in steps of 1/2048 mm above -depth_limit_mm; 32768 is the surface.
  std::vector<std::uint16_t> nodes;
};

/// Depths are kept within this of the surface, on both sides.
inline constexpr double depth_limit_mm = 16.0;

/// Depth at a point, trilinear between nodes; outside the lattice that of its nearest place [mm,
/// positive inside].
double depth_at(const DepthVolume& volume, const Vec3& point_in_bone_mm) noexcept;

/// Another way to compute a look has another number, so that none is shown that was kept of the way
/// before.
inline constexpr std::int64_t look_version = 1;

struct BoneLook {
  /// Another content has another; given by whoever asked for it.
  std::uint64_t id = 0;
  DepthVolume depth;
  /// Absent: all bone is cortical.
  std::optional<simulator::CortexLaw> cortex;
};

/// Computes it: a job's work (about a second for a phalanx, three for a metatarsal).
/// shape   the lattice reaches 6 mm beyond the bone
/// needs   id is not 0 and was not given to another content
/// errors  whatever `progress` throws; it is told the fraction done
/// thread  any; no graphics
BoneLook look_of(std::uint64_t id, const simulator::Bone& bone, const Progress& progress = {});
/// The same for a closed mesh that is all cortex.
BoneLook look_of(std::uint64_t id, const simulator::IndexedMesh& outer,
                 const Progress& progress = {});

/// Whether light reaches a point of the skin: 1 on a free surface, towards 0 in a hollow.
/// source  Quilez, distance field ambient occlusion: what of a few steps along the normal the
///         surface lets free
double openness_at(const DepthVolume& volume, const Vec3& point_in_bone_mm,
                   const Vec3& normal) noexcept;

}  // namespace hallux::ui
