/// The station: finds the devices of this machine, opens, homes and keeps them, and lends them to
/// whoever operates or looks. The program owns one.
///
///     buses --once a second, on a thread of its own--> list
///     open(id) --> port, kept until it is closed or the device is gone
///
/// A device that was pulled out and is plugged in again is opened again where it was open, in
/// whatever socket it is; whoever borrowed it asks for its port anew.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "simulator/device/port/device_port.h"
#include "simulator/device/station/found_device.h"

namespace hallux::simulator {

/// The driver of a device that was found.
/// needs   it is usable and no mouse
std::unique_ptr<DeviceDriver> driver_of(const FoundDevice& device, const DeviceSettings& settings,
                                        HidLibrary& hid);

class Station {
 public:
  explicit Station(StationSettings settings);
  /// Every device is given zero and let go.
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// As the buses were seen last, at most a second ago.
  std::vector<FoundDevice> devices() const;
  /// Looks now.
  std::vector<FoundDevice> look();

  /// The port of that device, opened where it was not; nullptr where it is not there, is no
  /// device of a port, or cannot be used (the list says why).
  std::shared_ptr<DevicePort> open(const std::string& id);
  /// The port of one that was opened, as the station has it now; nullptr while the device is away.
  std::shared_ptr<DevicePort> port_of(const std::string& id) const;
  /// Nobody wants it any more; whoever still has its port keeps it.
  void close(const std::string& id);

  StationSettings settings() const;
  /// Devices that are opened from now on have these.
  void set(StationSettings settings);

 private:
  void watch(const std::stop_token& stop);
  /// Those that were open and are there again.
  void open_again();
  std::shared_ptr<DevicePort> open_port(const FoundDevice& device);

  Buses buses_;
  /// One at a time asks them.
  std::mutex asking_;
  mutable std::mutex mutex_;
  std::condition_variable_any wakes_;
  /// Under the mutex, with what follows.
  StationSettings settings_;
  std::vector<FoundDevice> devices_;
  /// Of those that somebody wants; nullptr while the device is away.
  std::map<std::string, std::shared_ptr<DevicePort>> wanted_;
  /// Last: joined before the rest goes.
  std::jthread thread_;
};

}  // namespace hallux::simulator
