/// A rail for a hand that nothing pushes back: it lies in a plane, whatever bone does to it.
///
/// A guide pushes (contact/guide.h), and a mouse cannot be pushed: its hand in the middle gives way
/// to bone and follows its pointer. Asked to be led like in a slot, pointer and hand are kept in
/// the plane instead. The way there is gone gently.
#pragma once

#include "simulator/base/transform.h"

namespace hallux::simulator {

/// Points with normal . p = offset, in which the middle of the blade is to lie.
struct Rail {
  /// Unit; either way round.
  Vec3 normal_in_world{0.0, 0.0, 1.0};
  double offset_mm = 0.0;
};

/// Of the way to the rail, and of a turn towards it.
inline constexpr double rail_speed_mm_s = 20.0, rail_turn_rad_s = 0.6;

/// The pose after `duration_s` on its way into the rail; in it, it stays.
/// needs   duration_s >= 0; a normal of unit length
RigidTransform railed(const RigidTransform& world_from_tool, const Rail& rail,
                      double duration_s) noexcept;

/// Whether the pose lies in the rail but for rounding.
bool lies_in(const Rail& rail, const RigidTransform& world_from_tool) noexcept;

}  // namespace hallux::simulator
