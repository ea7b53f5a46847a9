/// Implants in the way of a running tool. Inside this room only.
#pragma once

#include <cstdint>
#include <span>

#include "simulator/cutting/hole/capsule.h"

namespace hallux::simulator {

/// The first of the implants in which one of the points lies, or -1: no saw, drill or wire goes on
/// there. A saw asks with its teeth, a drill or wire with its tip.
/// shape   points and implants in one frame
/// thread  haptic; allocates nothing
std::int32_t metal_at(std::span<const Vec3> points_mm, std::span<const Capsule> metal) noexcept;

}  // namespace hallux::simulator
