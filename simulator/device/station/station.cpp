#include "simulator/device/station/station.h"

#include <chrono>
#include <utility>

#include "simulator/device/falcon/falcon_driver.h"
#include "simulator/device/raw_hid_arm/arm_driver.h"
#include "simulator/device/space_mouse/space_mouse_driver.h"

namespace hallux::simulator {

namespace {

/// The libraries tell of no plug that is put in, so the buses are asked.
constexpr std::chrono::seconds between_looks{1};

std::unique_ptr<DeviceDriver> falcon_driver(const FoundDevice& device,
                                            const DeviceSettings& settings) {
  PluggedDevice plugged;
  plugged.node = device.address;
  FalconSettings falcon;
  falcon.firmware = settings.firmware;
  falcon.counts_per_newton_metre =
      settings.counts_per_newton_metre.value_or(falcon.counts_per_newton_metre);
  return std::make_unique<FalconDriver>(
      [plugged] { return open_usb(plugged, falcon_pipe_in, falcon_pipe_out); }, std::move(falcon));
}

}  // namespace

std::unique_ptr<DeviceDriver> driver_of(const FoundDevice& device, const DeviceSettings& settings,
                                        HidLibrary& hid) {
  const auto open_hid = [&hid, node = device.address] { return hid.open(node); };
  switch (device.kind) {
    case DeviceKind::Falcon:
      return falcon_driver(device, settings);
    case DeviceKind::RawHidArm:
      return std::make_unique<ArmDriver>(open_hid, settings.geometry.value_or(ArmGeometry{}));
    case DeviceKind::Inverse3:
      return std::make_unique<Inverse3Driver>(inverse_access(device.service_port), device.serial);
    case DeviceKind::SpaceMouse:
      return std::make_unique<SpaceMouseDriver>(open_hid, device.name,
                                                device.axis_limit.value_or(usual_axis_limit));
    default:
      return nullptr;
  }
}

Station::Station(StationSettings settings) : settings_(std::move(settings)) {
  thread_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

Station::~Station() = default;

StationSettings Station::settings() const {
  const std::lock_guard lock(mutex_);
  return settings_;
}

void Station::set(StationSettings settings) {
  const std::lock_guard lock(mutex_);
  settings_ = std::move(settings);
}

std::vector<FoundDevice> Station::devices() const {
  const std::lock_guard lock(mutex_);
  return devices_;
}

std::vector<FoundDevice> Station::look() {
  const std::lock_guard asking(asking_);
  std::vector<FoundDevice> found = find_devices(buses_, settings());
  const std::lock_guard lock(mutex_);
  devices_ = found;
  return found;
}

void Station::watch(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    look();
    open_again();
    std::unique_lock lock(mutex_);
    wakes_.wait_for(lock, stop, between_looks, [] { return false; });
  }
}

void Station::open_again() {
  const std::lock_guard lock(mutex_);
  for (auto& [id, port] : wanted_) {
    if (port && port->phase() == PortPhase::Ended) port.reset();
    const FoundDevice* device = device_with(devices_, id);
    if (!port && device != nullptr && device->is_usable()) port = open_port(*device);
  }
}

std::shared_ptr<DevicePort> Station::open_port(const FoundDevice& device) {
  std::unique_ptr<DeviceDriver> driver =
      driver_of(device, settings_.of(device.id, std::string(facts_of(device.kind).id)), buses_.hid);
  return driver ? std::make_shared<DevicePort>(std::move(driver)) : nullptr;
}

std::shared_ptr<DevicePort> Station::open(const std::string& id) {
  const std::vector<FoundDevice> found = look();
  const std::lock_guard lock(mutex_);
  const FoundDevice* device = device_with(found, id);
  if (device == nullptr || !device->is_usable()) return nullptr;
  std::shared_ptr<DevicePort>& port = wanted_[id];
  if (port && port->phase() == PortPhase::Ended) port.reset();
  if (!port) port = open_port(*device);
  return port;
}

std::shared_ptr<DevicePort> Station::port_of(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto wanted = wanted_.find(id);
  return wanted == wanted_.end() ? nullptr : wanted->second;
}

void Station::close(const std::string& id) {
  std::shared_ptr<DevicePort> port;
  const std::lock_guard lock(mutex_);
  const auto wanted = wanted_.find(id);
  if (wanted == wanted_.end()) return;
  port = std::move(wanted->second);
  wanted_.erase(wanted);
}

}  // namespace hallux::simulator
