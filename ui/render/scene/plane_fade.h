/// Planes that are seen edge on: how much of the rectangle is drawn, and what stands in its place.
#pragma once

#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// Seen more flatly than this a plane is only its line; from the second angle on it is whole.
inline constexpr double edge_on_rad = 0.140, face_on_rad = 0.420;

/// Angle between a plane and the line of sight to its middle, in [0, pi/2] [rad].
double sight_angle_rad(const RigidTransform& world_from_plane,
                       const Vec3& eye_in_world_mm) noexcept;
/// Share of the rectangle's opacity that is left, 0 to 1.
double face_on_share(const RigidTransform& world_from_plane, const Vec3& eye_in_world_mm) noexcept;

/// What that plane cuts, as a line on the bone; the more it is seen edge on, the stronger, with a
/// tick towards its normal.
CuttingLine line_of(const PlaneGhost& plane, const Vec3& eye_in_world_mm) noexcept;
/// The lines of a scene: its own, then those of its planes.
std::vector<CuttingLine> all_lines(const Scene& scene, const Vec3& eye_in_world_mm);

}  // namespace hallux::ui
