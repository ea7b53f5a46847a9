/// Poses of what the hand holds besides the saw.
#pragma once

#include <optional>

#include "simulator/base/transform.h"
#include "simulator/mesh/bvh.h"

namespace hallux::ui {

/// x along a unit direction, y as near to a wish as may be.
RigidTransform pose_along(const Vec3& along, const Vec3& y_wish, const Vec3& origin_mm) noexcept;

/// Of the jaws of forceps around a piece: just outside it where it is nearest to the hand, from the
/// hand towards it; in the frame of the piece. Nothing of a piece without a surface.
std::optional<RigidTransform> jaws_around(const simulator::Bvh& piece,
                                          const RigidTransform& piece_from_hand) noexcept;
/// How far they are open around it.
inline constexpr double jaws_opening_mm = 6.0;

}  // namespace hallux::ui
