/// A device that the station has lent to an attempt: where it is gone and comes again, the attempt
/// goes on with it.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "simulator/device/port_device.h"
#include "simulator/device/station/station.h"

namespace hallux::simulator {

class LentDevice final : public SteeredDevice {
 public:
  /// Borrows the station. The port is running.
  LentDevice(Station& station, FoundDevice found, const std::shared_ptr<DevicePort>& port,
             const PortDeviceSetup& setup);
  /// The device is given nothing; the station keeps it.
  ~LentDevice() override;
  LentDevice(const LentDevice&) = delete;
  LentDevice& operator=(const LentDevice&) = delete;

  void aim(const Aim& aim) noexcept override { held_->aim(aim); }
  /// Of an arm; a 3D mouse is lifted by letting go.
  /// thread  any
  void lift(bool is_lifted) noexcept;
  /// thread  window
  void look(const Quat& world_from_view) noexcept;
  DeviceDescription description() const override { return held_->description(); }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override {
    return held_->exchange(force_in_world_newton, tick, state);
  }

  std::optional<DeviceFacts> facts() const override;

 private:
  void watch(const std::stop_token& stop);
  void go_on_with(std::shared_ptr<DevicePort> port);

  Station& station_;
  FoundDevice found_;
  /// Of these two one is there: it is what is held.
  std::unique_ptr<ArmDevice> arm_;
  std::unique_ptr<RateDevice> rate_;
  SteeredDevice* held_ = nullptr;
  mutable std::mutex mutex_;
  /// Every one that was ever exchanged with, the newest last: the haptic thread may still read it.
  std::vector<std::shared_ptr<DevicePort>> ports_;
  /// Last: joined before the rest goes.
  std::jthread watch_;
};

/// Lends a device that runs; nullptr where it does not.
std::unique_ptr<LentDevice> lend(Station& station, const std::string& id,
                                 const PortDeviceSetup& setup);

/// What is set for a device of the station, over what is usual for its kind.
PortDeviceSetup setup_of(const Station& station, const FoundDevice& device,
                         const RigidTransform& world_from_start, const Quat& world_from_view);

}  // namespace hallux::simulator
