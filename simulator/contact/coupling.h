/// The spring between hand and tool: what its stretch does to the hand, and how fast a tool comes
/// after the hand. One law for blades and for whatever bores. Inside this room only.
#pragma once

#include "simulator/contact/tool_motion.h"

namespace hallux::simulator {

/// No tool goes further in one tick: that of a faster hand comes after it.
inline constexpr double tick_travel_limit_mm = 1.5;

/// The part of a force or torque that is within its limit.
double share_within(const Vec3& value, double limit) noexcept;

struct CouplingPull {
  Vec3 force_newton{0.0, 0.0, 0.0};
  Vec3 torque_newton_mm{0.0, 0.0, 0.0};
  bool is_force_limited = false;
};

/// What the stretch from hand to tool does to the hand, within the limits.
CouplingPull coupling_pull(const ProxyMotion& stretch, const ContactSettings& settings) noexcept;

/// How far a tool may go in a tick in which the hand went `hand_way_mm`. One that bone holds, or
/// held until now (`is_gentle`), comes after the hand at no more than the speed of giving way.
double travel_limit_mm(double hand_way_mm, double duration_s, bool is_gentle,
                       const ContactSettings& settings) noexcept;

}  // namespace hallux::simulator
