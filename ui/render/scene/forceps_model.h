/// Pointed reduction forceps as triangles: two arms that cross at a joint, with jaws that curve
/// towards each other and handles with rings.
///
///      rings  handles   joint   jaws           y
///       O=======\      /---------.             |
///                >=o=<            > points     +-- x
///       O=======/      \---------'
///
/// One arm is the other seen in a mirror. An arm's frame: origin at the joint, x to its point, y
/// outwards of its jaw.
#pragma once

#include "simulator/base/transform.h"
#include "ui/render/scene/tool_mesh.h"

namespace hallux::ui {

/// The jaw of the arm whose point is at y > 0, with its half of the joint.
ToolMesh jaw_mesh();
/// Its handle, which lies at y < 0.
ToolMesh forceps_handle_mesh();

/// Where that arm stands while the points are so far apart; the other one is seen in the mirror
/// y = 0 of the tool frame. The points stay in the tool frame's y axis.
/// units   above what the jaws open to, that far
RigidTransform tool_from_arm(double opening_mm) noexcept;

/// From the joint to the point.
inline constexpr double jaw_length_mm = 46.0;
inline constexpr double forceps_opening_most_mm = 50.0;
/// From the joint to the end of the handle.
inline constexpr double forceps_handle_mm = 122.0;
/// No point of an arm is further than that from its x axis in the plane of the arms, or beside it.
inline constexpr double forceps_arm_half_mm = 32.0, forceps_half_thickness_mm = 4.0;
/// No point of a jaw is further from it.
inline constexpr double jaw_half_mm = 14.5;

}  // namespace hallux::ui
