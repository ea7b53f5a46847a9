/// A device that a window leads: the mouse and keys, and whatever else has no hand of its own.
#pragma once

#include <cstdint>

#include "simulator/device/haptic_device.h"

namespace hallux::simulator {

class SteeredDevice : public HapticDevice {
 public:
  /// Without a new target for longer, every switch is off.
  static constexpr std::int64_t silence_ticks = 1500;

  /// Where the hand is led from now on; to be said again and again while a switch is on.
  /// world_from_target  pose of the saw [mm]
  /// switches           bits of Switch
  /// thread  window
  virtual void aim(const RigidTransform& world_from_target, std::uint32_t switches) noexcept = 0;
};

}  // namespace hallux::simulator
