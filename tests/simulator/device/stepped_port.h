/// A port without a thread: each force that is said is one exchange with its driver, a millisecond
/// of virtual time later.
#pragma once

#include "simulator/device/port/port.h"

namespace hallux::simulator {

class SteppedPort final : public Port {
 public:
  /// Of an opened driver, which outlives it.
  explicit SteppedPort(DeviceDriver& driver) : driver_(driver), cycle_(driver, now_) {}

  /// One exchange with what was said last.
  void step() noexcept {
    cycle_.run(said_, [this] { return now_ += std::chrono::microseconds(500); });
  }
  void say(const Vec3& force_in_device_newton) noexcept override {
    said_ = {force_in_device_newton, said_.number + 1};
  }
  /// Exchanged with before each look.
  const PortState& newest() noexcept override {
    if (!cycle_.is_over()) step();
    return cycle_.state();
  }
  DeviceDescription description() const override { return driver_.description(); }

  const PortCycle& cycle() const noexcept { return cycle_; }

 private:
  DeviceDriver& driver_;
  PortCycle::Time now_{};
  PortCycle cycle_;
  SaidForce said_;
};

}  // namespace hallux::simulator
