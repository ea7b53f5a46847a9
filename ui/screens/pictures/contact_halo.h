/// Where the teeth of a saw meet a bone, before they do, when they do, and behind it.
#pragma once

#include <optional>
#include <span>

#include "simulator/mesh/bvh.h"
#include "simulator/tool/saw.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// A bone as rays find it; borrowed.
struct BoneSurface {
  const simulator::Bvh& tree;
  RigidTransform world_from_bone;
};

/// Further from the bone the teeth have no ring on it.
inline constexpr double halo_reach_mm = 40.0;
/// So near to the surface the teeth are on it.
inline constexpr double halo_contact_mm = 0.25;

/// The shortest way from the tooth line along the feed to the bone; 0 where a tooth is in it;
/// nothing where it would pass the bone or is further than halo_reach_mm away.
std::optional<double> way_to_bone_mm(const BoneSurface& bone, const RigidTransform& world_from_tool,
                                     const simulator::Blade& blade) noexcept;

/// The halo as one sees it from there; nothing where no bone is ahead of the teeth.
std::optional<ContactHalo> contact_halo(std::span<const BoneSurface> bones, const SawInScene& saw,
                                        const Vec3& eye_in_world_mm) noexcept;

}  // namespace hallux::ui
