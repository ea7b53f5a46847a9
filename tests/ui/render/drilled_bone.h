/// Places on the phalanx of an OperatingWorld at which something is drilled, driven in or held.
#pragma once

#include "tests/ui/render/operating_world.h"

namespace hallux::tests {

/// Where a straight line goes through the phalanx.
struct DrillLine {
  /// Origin where it goes in, x along it.
  RigidTransform world_from_line;
  /// Until it comes out.
  double through_mm = 0.0;

  /// A tool that goes along it, its tip so deep.
  RigidTransform world_from_tool(double depth_mm) const noexcept;
};

/// The line through a point of the bone's frame, along a direction of it.
/// needs   the line meets the bone
DrillLine drill_line(const OperatingWorld& world, const Vec3& through_in_bone_mm,
                     const Vec3& way_in_bone);
/// The hole of that radius where the line goes in.
ui::HoleInScene hole_at(const OperatingWorld& world, const DrillLine& line, double radius_mm);

}  // namespace hallux::tests
