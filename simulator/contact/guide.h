/// The guide: the planned plane as a virtual fixture that leads the hand while it practises.
///
///     within 0.5 mm and 1 degree of the plane: nothing
///         --beyond--> back to it, by a share of the coupling's stiffness,
///                     at most 35 % of the greatest force and torque
///
/// It leads the hand, and the tool follows: the blade is asked where it is, the hand is pushed. It
/// comes in softly, belongs to the step at hand, and leads to that step's own kerf once it has one;
/// in a kerf its walls lead.
/// source  docs/haptics.md, Where the tool is
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "simulator/base/transform.h"
#include "simulator/record/guidance.h"

namespace hallux::simulator {

inline constexpr double guide_play_mm = 0.5;
inline constexpr double guide_play_rad = 0.0175;
inline constexpr double guide_share_of_stiffness = 0.6;
inline constexpr double guide_share_when_soft = 1.0 / 3.0;
inline constexpr double guide_share_of_limit = 0.35;
inline constexpr double guide_comes_in_s = 0.5;

/// Where the middle of the blade is to lie: points with normal . p = offset. Which way the normal
/// looks does not matter.
struct GuidePlane {
  /// Unit.
  Vec3 normal_in_bone{0.0, 0.0, 1.0};
  double offset_mm = 0.0;
};

/// As many as an operation has at most.
inline constexpr std::size_t guided_steps_at_most = 64;

/// For an attempt: how firmly, and the plane of each of the operation's steps, nothing where a step
/// has none.
struct GuidePlan {
  Guidance guidance = Guidance::None;
  std::array<std::optional<GuidePlane>, guided_steps_at_most> of_step{};
};

/// What the guide is a share of.
struct GuideStrength {
  double stiffness_newton_per_mm = 0.0, force_limit_newton = 0.0;
  double torsion_newton_mm_per_rad = 0.0, torque_limit_newton_mm = 0.0;
};

/// On the hand, bone frame; the torque about the tool's origin.
struct GuidePush {
  Vec3 force_newton{0.0, 0.0, 0.0};
  Vec3 torque_newton_mm{0.0, 0.0, 0.0};
};

/// needs   a normal of unit length
/// errors  none: total, allocates nothing; no push with Guidance::None
/// thread  haptic
GuidePush guide_push(const RigidTransform& bone_from_tool, const GuidePlane& plane,
                     Guidance guidance, const GuideStrength& full) noexcept;

}  // namespace hallux::simulator
