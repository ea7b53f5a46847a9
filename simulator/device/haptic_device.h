/// What every device is to the loop: one exchange a tick, force out, newest state in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "simulator/base/transform.h"
#include "simulator/device/device_facts.h"
#include "simulator/device/device_limits.h"

namespace hallux::simulator {

/// How a living device is told from one that only repeats itself; what it cannot say is not asked
/// for.
struct DevicePulse {
  /// Its state never stays the same to the last bit for more ticks, because a converter or an
  /// encoder flickers; 0: it may, as of an arm that lies at rest.
  std::int64_t flicker_ticks = 0;
  /// RawDeviceState::packet grows with each packet that came.
  bool numbers_packets = false;
  /// In which a packet comes, where it numbers them; at least 1.
  std::int64_t period_ticks = 1;
};

struct DeviceDescription {
  std::string name;
  /// "scripted", "mouse", "arm": comparisons of scores stay within a class.
  std::string device_class;
  /// Of what pushes a hand; none where nothing does: it is told the simulated force as it is.
  std::optional<DeviceLimits> limits = std::nullopt;
  DevicePulse pulse = {};
  /// World millimetres for one of the hand; above 0. What is rendered is felt by that much stiffer.
  double motion_scale = 1.0;
  /// Its grip says how it is turned; else a window or another hand turns the saw.
  bool measures_rotation = false;
};

/// What the device said; not yet rounded, not yet trusted.
struct RawDeviceState {
  RigidTransform world_from_handle;
  /// Bits of Switch.
  std::uint32_t switches = 0;
  /// Of the packet that said it, where the device numbers them.
  std::uint64_t packet = 0;
  /// From now on it is said by another that pushes nobody back and numbers nothing.
  bool is_handed_over = false;
};

class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  virtual DeviceDescription description() const = 0;
  /// For the certificate; nothing where no device of its own is behind it.
  /// thread  any
  virtual std::optional<DeviceFacts> facts() const { return std::nullopt; }
  /// Sends the force [N, world frame; the device's own newtons where it has limits] and takes the
  /// newest state for simulated tick `tick`. False where the device is gone. Never waits longer
  /// than one period.
  /// thread  haptic; allocates nothing
  virtual bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                        RawDeviceState& state) noexcept = 0;
};

}  // namespace hallux::simulator
