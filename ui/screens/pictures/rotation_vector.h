/// A rotation as axis times angle.
#pragma once

#include "simulator/base/elementary.h"
#include "simulator/base/transform.h"

namespace hallux::ui {

/// By at most half a turn; 0 of no turn [rad].
inline Vec3 rotation_vector(const Quat& rotation) noexcept {
  const Quat turn = rotation.w < 0.0 ? -rotation : rotation;
  const Vec3 axis(turn.x, turn.y, turn.z);
  const double sine = length_of(axis);
  return sine > 0.0 ? 2.0 * elementary::atan2(sine, turn.w) / sine * axis : axis;
}

}  // namespace hallux::ui
