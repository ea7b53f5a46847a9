/// Questions a blade asks of the bone around it: which teeth stand in what, and whether an edge is
/// free. Inside this room only.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "simulator/contact/feed.h"
#include "simulator/contact/tissue.h"
#include "simulator/contact/tool_motion.h"

namespace hallux::simulator {

/// How far in front of the teeth bone is asked for: they stand on bone, not in it.
inline constexpr double probe_ahead_mm = 0.02;

/// The middle of each share of the tooth line, `ahead_mm` in front of it and `aside_mm` out of the
/// blade's plane [mm, bone frame].
std::array<Vec3, tooth_count> tooth_points(const RigidTransform& bone_from_tool, const Blade& blade,
                                           double ahead_mm, double aside_mm = 0.0) noexcept;

/// The hardest tissue over each tooth's thickness, asked `ahead_mm` in front of the tooth line;
/// `teeth` remembers.
/// thread  haptic; allocates nothing
std::array<Tissue, tooth_count> tissue_at_teeth(const RigidTransform& bone_from_tool,
                                                const Wound& bone, double ahead_mm,
                                                OfFragments<TeethMemory>& teeth) noexcept;

/// The hardest tissue of any fragment at a point.
/// thread  haptic; allocates nothing
Tissue tissue_at(const Vec3& point_in_wound_mm, const Wound& bone) noexcept;

/// How many teeth stand in one fragment.
std::int32_t teeth_in_fragment(const WoundFragment& standing, const RigidTransform& bone_from_tool,
                               TeethMemory& teeth) noexcept;

/// The engaged width per tissue over the tooth line (the hardest over a tooth's thickness), asked
/// `ahead_mm` in front of it; `teeth` remembers.
/// thread  haptic; allocates nothing
Engagement engagement(const RigidTransform& bone_from_tool, const Wound& bone, double ahead_mm,
                      OfFragments<TeethMemory>& teeth) noexcept;

/// The fragment in which most of the teeth stand; of as many the first, -1 where they stand in
/// none.
/// counts   whether a fragment of that number is asked about
template <typename Counts>
std::int32_t fragment_at_teeth(const RigidTransform& bone_from_tool, const Wound& bone,
                               OfFragments<TeethMemory>& teeth, const Counts& counts) noexcept {
  std::int32_t found = -1, most = 0;
  bone.visit_near(bone_from_tool.translation_mm, reach_of_blade_mm(bone.blade()),
                  [&](std::int32_t number, const WoundFragment& standing) {
                    if (!counts(number)) return;
                    const std::int32_t engaged = teeth_in_fragment(
                        standing, bone_from_tool, teeth[static_cast<std::size_t>(number)]);
                    if (engaged > most) found = number;
                    most = std::max(most, engaged);
                  });
  return found;
}
inline std::int32_t fragment_at_teeth(const RigidTransform& bone_from_tool, const Wound& bone,
                                      OfFragments<TeethMemory>& teeth) noexcept {
  return fragment_at_teeth(bone_from_tool, bone, teeth, [](std::int32_t) { return true; });
}

/// Whether standing bone lies on the blade's edge on the side `side` (+1 or -1 along the tooth
/// line).
bool edge_meets_bone(const RigidTransform& bone_from_tool, const Wound& bone, double side) noexcept;

/// Whether any of the blade (middle line or edges) lies within a fragment's outer surface as it was
/// before its kerfs.
bool blade_is_in_bone(const RigidTransform& bone_from_tool, const Wound& bone) noexcept;

}  // namespace hallux::simulator
