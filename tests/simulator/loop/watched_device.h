/// Any device while an attempt runs with it: what it was given is remembered, what it says may be
/// garbled for a while.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "simulator/device/haptic_device.h"

namespace hallux::tests {

/// Alters what a device says, or answers false as if it were gone; `last_good` is what it said
/// before the garbled ticks.
using Garble = std::function<bool(simulator::RawDeviceState& state,
                                  const simulator::RawDeviceState& last_good)>;

struct GarbledTicks {
  /// Not that one any more.
  std::int64_t first_tick = 0, end_tick = 0;
  Garble garble = {};
};

class WatchedDevice final : public simulator::HapticDevice {
 public:
  /// Borrows the device for its lifetime.
  explicit WatchedDevice(simulator::HapticDevice& device, GarbledTicks garbled = {})
      : device_(device), garbled_(std::move(garbled)) {}

  simulator::DeviceDescription description() const override { return device_.description(); }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                simulator::RawDeviceState& state) noexcept override {
    given_newton.push_back(force_in_world_newton);
    bool came = device_.exchange(force_in_world_newton, tick, state);
    if (tick < garbled_.first_tick) last_good_ = state;
    if (tick >= garbled_.first_tick && tick < garbled_.end_tick) {
      came = garbled_.garble(state, last_good_);
    }
    if (after_exchange) after_exchange(tick);
    return came;
  }

  /// At each exchange.
  std::vector<Vec3> given_newton;
  /// Called with its tick.
  std::function<void(std::int64_t)> after_exchange;

 private:
  simulator::HapticDevice& device_;
  GarbledTicks garbled_;
  simulator::RawDeviceState last_good_;
};

}  // namespace hallux::tests
