/// Implants in the way of a running tool. Inside this room only.
#pragma once

#include <span>

#include "simulator/cutting/hole/capsule.h"

namespace hallux::simulator {

/// Whether one of the points lies in one of the implants: no saw, drill or wire goes on there. A
/// saw asks with its teeth, a drill or wire with its tip. Left out by the caller is the implant
/// that a tool is led by, as a cannulated screw is by its guide wire.
/// thread  haptic; allocates nothing
bool meets_metal(std::span<const Vec3> points_in_body_mm, std::span<const Capsule> metal) noexcept;

}  // namespace hallux::simulator
