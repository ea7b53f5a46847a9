/// A device that a window leads: the mouse and keys, and whatever else has no hand of its own.
#pragma once

#include <cstdint>

#include "simulator/device/haptic_device.h"

namespace hallux::simulator {

class SteeredDevice : public HapticDevice {
 public:
  /// Without a new target for longer, every switch is off.
  static constexpr std::int64_t silence_ticks = 1500;

  /// Where the hand is led.
  struct Aim {
    /// Pose of the saw [mm].
    RigidTransform world_from_target;
    /// Bits of Switch.
    std::uint32_t switches = 0;
    /// A unit direction along which the hand is as the target is, whatever pushes it; zero: it
    /// yields to all sides.
    Vec3 unyielding_in_world{0.0, 0.0, 0.0};
  };

  /// From now on; to be said again and again while a switch is on.
  /// thread  window
  virtual void aim(const Aim& aim) noexcept = 0;
};

}  // namespace hallux::simulator
