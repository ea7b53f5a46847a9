/// What the loop has of a port: a force to say, the newest state to read. Inside this corner only.
#pragma once

#include "simulator/device/port/port_cycle.h"

namespace hallux::simulator {

class Port {
 public:
  virtual ~Port() = default;

  /// thread  the borrower's; takes no memory, makes no system call
  virtual void say(const Vec3& force_in_device_newton) noexcept = 0;
  /// What the device said last; valid until the next call.
  /// thread  the borrower's; likewise
  virtual const PortState& newest() noexcept = 0;
  /// Of the opened device; before, what is known of its kind.
  /// thread  any
  virtual DeviceDescription description() const = 0;
};

}  // namespace hallux::simulator
