/// How far a body may move rigidly before it first touches: conservative advancement.
/// Inside this corner only.
///
/// From a pose at which the gap to the surface is g, no point can reach the surface before the
/// fastest one has gone g: so the motion may go on by g / (the longest path), again and again. It
/// never jumps over a wall, however thin.
/// source  Mirtich, Impulse-based dynamic simulation of rigid body systems (1996), 2.3.2
#pragma once

#include "simulator/base/transform.h"

namespace hallux::simulator {

/// A motion between two poses, as `interpolate` goes.
struct RigidMotion {
  RigidTransform bone_from_start, bone_from_end;
};

/// At least the speed of any point within `radius_mm` of the frame's origin, in millimetres per
/// whole motion.
double greatest_speed_mm(const RigidMotion& motion, double radius_mm) noexcept;

/// Nearer than this to the surface is contact [mm]; a motion stops up to this far before it and
/// never beyond.
inline constexpr double contact_tolerance_mm = 1.0e-4;
/// A motion that grazes the surface may take more steps than this: then it stops where it is, still
/// free.
inline constexpr int advance_limit = 200;

struct Advance {
  /// Part of the motion, from its start.
  double free_share = 1.0;
  bool is_stopped = false;
  /// Stopped by the surface; otherwise by the limit of steps.
  bool is_contact = false;
};

/// shape   gap_mm(pose, within_mm): distance to the surface at a pose of the motion, or `within_mm`
///         where it is at least that
template <typename Gap>
Advance advance_until_contact(const RigidMotion& motion, double radius_mm,
                              const Gap& gap_mm) noexcept {
  const double speed_mm = greatest_speed_mm(motion, radius_mm);
  Advance advance{0.0};
  for (int i = 0; i < advance_limit; ++i) {
    const RigidTransform pose =
        interpolate(motion.bone_from_start, motion.bone_from_end, advance.free_share);
    const double left_mm = (1.0 - advance.free_share) * speed_mm + contact_tolerance_mm;
    const double away_mm = gap_mm(pose, left_mm);
    if (away_mm <= contact_tolerance_mm) return {advance.free_share, true, true};
    if (away_mm >= left_mm) return {1.0, false, false};
    advance.free_share += (away_mm - 0.5 * contact_tolerance_mm) / speed_mm;
    if (advance.free_share >= 1.0) return {1.0, false, false};
  }
  return {advance.free_share, true, false};
}

}  // namespace hallux::simulator
