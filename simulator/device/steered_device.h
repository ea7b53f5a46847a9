/// A device that a window has a part in: it leads what has no hand of its own, and says how the
/// person looks, whether the hand is lifted and what keys and buttons of the window switch.
#pragma once

#include <cstdint>

#include "simulator/device/haptic_device.h"
#include "simulator/device/port/device_trouble.h"

namespace hallux::simulator {

class SteeredDevice : public HapticDevice {
 public:
  /// Without a new target for longer, every switch is off.
  static constexpr std::int64_t silence_ticks = 1500;

  /// What of the saw's pose the window leads; the rest is the hand's that holds the device.
  enum class Led : std::uint8_t { Pose, Rotation, Nothing };

  /// Where the hand is led, and what else the window says.
  struct Aim {
    /// Pose of the saw [mm].
    RigidTransform world_from_target;
    /// Bits of Switch.
    std::uint32_t switches = 0;
    /// A unit direction along which the hand is as the target is, whatever pushes it; zero: it
    /// yields to all sides.
    Vec3 unyielding_in_world{0.0, 0.0, 0.0};
    /// Counts how often the window switched anything. A device with buttons of its own is as they
    /// left it until this is another.
    std::uint32_t orders = 0;
    /// The hand that holds the device moves without the saw, and nothing pushes it.
    bool is_lifted = false;
    /// Axes of the person's view: x right, y up, z to the person.
    Quat world_from_view{1.0, 0.0, 0.0, 0.0};
  };

  /// From now on; to be said again and again while a switch is on.
  /// thread  window
  virtual void aim(const Aim& aim) noexcept = 0;
  /// thread  window
  virtual Led led() const noexcept { return Led::Pose; }
  /// Why it is away, or gives no force; none: it is well.
  /// thread  window
  virtual TroubleReport trouble() const { return {}; }
  /// From now on mouse and keys lead the saw from there, whatever becomes of this device; nothing
  /// where they do so already.
  /// thread  window
  virtual void hand_over(const RigidTransform& /*world_from_start*/) {}
};

}  // namespace hallux::simulator
