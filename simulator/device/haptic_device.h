/// What every device is to the loop: one exchange a tick, force out, newest state in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "simulator/base/transform.h"
#include "simulator/device/device_limits.h"

namespace hallux::simulator {

struct DeviceDescription {
  std::string name;
  std::string
      device_class;  ///< "scripted", "mouse", "arm": comparisons of scores stay within a class
  /// Of what pushes a hand; none where nothing does: it is told the simulated force as it is.
  std::optional<DeviceLimits> limits = std::nullopt;
};

/// What the device said; not yet rounded, not yet trusted.
struct RawDeviceState {
  RigidTransform world_from_handle;
  std::uint32_t switches = 0;  ///< bits of Switch
};

class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  virtual DeviceDescription description() const = 0;
  /// Sends the force [N, world frame] and takes the newest state for simulated tick `tick`.
  /// False where the device is gone. Never waits longer than one period.
  /// thread  haptic; allocates nothing
  virtual bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                        RawDeviceState& state) noexcept = 0;
};

}  // namespace hallux::simulator
