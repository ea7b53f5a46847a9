/// A device that the station has lent to an attempt: where it is gone and comes again, the attempt
/// goes on with it, or with mouse and keys where the person takes those.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "simulator/device/mouse.h"
#include "simulator/device/port_device.h"
#include "simulator/device/station/station.h"

namespace hallux::simulator {

class LentDevice final : public SteeredDevice {
 public:
  /// The station stays for as long as it is lent. The port is running.
  LentDevice(std::shared_ptr<Station> station, FoundDevice found,
             const std::shared_ptr<DevicePort>& port, const PortDeviceSetup& setup);
  /// The device is given nothing; the station keeps it.
  ~LentDevice() override;
  LentDevice(const LentDevice&) = delete;
  LentDevice& operator=(const LentDevice&) = delete;

  void aim(const Aim& aim) noexcept override;
  Led led() const noexcept override { return mouse_ ? mouse_->led() : held_->led(); }
  TroubleReport trouble() const override;
  void hand_over(const RigidTransform& world_from_start) override;
  DeviceDescription description() const override { return held_->description(); }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override;

  std::optional<DeviceFacts> facts() const override;

 private:
  void watch(const std::stop_token& stop);
  void go_on_with(std::shared_ptr<DevicePort> port);
  std::shared_ptr<DevicePort> newest_port() const;

  std::shared_ptr<Station> station_;
  FoundDevice found_;
  /// Of these two one is there: it is what is held.
  std::unique_ptr<ArmDevice> arm_;
  std::unique_ptr<RateDevice> rate_;
  SteeredDevice* held_ = nullptr;
  /// That took over; the window's, and once it is published the haptic thread's too.
  std::unique_ptr<MouseDevice> mouse_;
  std::atomic<MouseDevice*> taken_over_by_{nullptr};
  mutable std::mutex mutex_;
  /// Every one that was ever exchanged with, the newest last: the haptic thread may still read it.
  std::vector<std::shared_ptr<DevicePort>> ports_;
  /// Last: joined before the rest goes.
  std::jthread watch_;
};

/// Lends a device that runs; nullptr where it does not.
std::unique_ptr<LentDevice> lend(const std::shared_ptr<Station>& station, const std::string& id,
                                 const PortDeviceSetup& setup);

/// What is set for a device of the station and what its person chose, over what is usual for its
/// kind.
PortDeviceSetup setup_of(const Station& station, const FoundDevice& device, const HandChoice& own,
                         const RigidTransform& world_from_start, const Quat& world_from_view);

}  // namespace hallux::simulator
