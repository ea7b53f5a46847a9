/// How far a triangle lies from a box: exact up to rounding, with the two points that are nearest.
#pragma once

#include <array>

#include "simulator/base/transform.h"

namespace hallux::simulator {

/// A box around the origin of a frame of its own: a blade, a guide, in the frame of a bone.
struct OrientedBox {
  RigidTransform bone_from_box;
  Vec3 half_mm{0.0, 0.0, 0.0};
};

/// In the box's frame; both points are the same where triangle and box meet.
struct BoxGap {
  double squared_mm2 = 0.0;
  Vec3 on_triangle_mm{0.0, 0.0, 0.0};
  Vec3 on_box_mm{0.0, 0.0, 0.0};
};

/// needs   the corners are said in the box's frame
BoxGap box_gap(const std::array<Vec3, 3>& corner_mm, const Vec3& half_mm) noexcept;

}  // namespace hallux::simulator
