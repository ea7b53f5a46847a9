/// Where an operation is first seen from, as data: a direction in the bone, a turn of the picture,
/// and how much is shown.
#pragma once

#include "ui/render/scene/camera.h"

namespace hallux::ui {

/// Looks at the site from a direction of the bone frame (x distal, y dorsal, z lateral).
struct StartView {
  /// Of the direction from the site to the viewer: about dorsal, from distal towards lateral.
  double azimuth_rad = 0.0;
  /// Likewise: up from the plane of distal and lateral towards dorsal.
  double elevation_rad = 0.0;
  /// Of the picture about the line of sight, clockwise as the viewer sees it; at 0 dorsal is up.
  double roll_rad = 0.0;
  /// Of the ball around the site that the picture shows wholly.
  double radius_mm = 30.0;
};

/// aspect  the picture's width over its height
Camera camera_of(const StartView& view, const RigidTransform& world_from_bone,
                 const Vec3& site_in_bone_mm, const Viewer& viewer, double aspect) noexcept;

}  // namespace hallux::ui
