/// The devices that are plugged in, each with why it can be used or not. Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "simulator/device/bus/hid_library.h"
#include "simulator/device/bus/usb_library.h"
#include "simulator/device/inverse3/inverse_service.h"
#include "simulator/device/station/device_kind.h"
#include "simulator/device/station/station_settings.h"

namespace hallux::simulator {

struct FoundDevice {
  /// The kind's; with the serial where there are several, with the socket where that is the same.
  std::string id;
  DeviceKind kind = DeviceKind::Mouse;
  /// As the device names itself, or its kind.
  std::string name;
  /// Of the system's file, or of the service.
  std::string address;
  std::string serial, bus_path;
  /// As far as it is known without opening it; none: it can be used.
  TroubleReport trouble;
  /// Of a HID device's axes.
  std::optional<std::int32_t> axis_limit;
  std::uint16_t vendor = 0, product = 0;
  /// Where a service speaks for it.
  std::uint16_t service_port = 0;

  bool is_usable() const noexcept { return !trouble; }
};

/// Through which devices are reached: a library's name and version.
struct DeviceLibrary {
  std::string name, version;
};
std::vector<DeviceLibrary> device_libraries();

/// Where devices are found.
struct Buses {
  HidLibrary hid;
  UsbLibrary usb;
  InverseService inverse;
};

/// What the buses know; the mouse is always there, and first.
std::vector<FoundDevice> find_devices(Buses& buses, const StationSettings& settings);

/// Where the service of the Inverse3 is asked.
std::uint16_t service_port(const StationSettings& settings);

/// An Inverse3 whose service is asked at that port and does not answer: for whoever asks for one.
FoundDevice unserved_inverse(std::uint16_t port);

/// The one with that id; nullptr where there is none.
const FoundDevice* device_with(const std::vector<FoundDevice>& devices, const std::string& id);

/// Gives each its id; kinds and serials are set.
void name_apart(std::vector<FoundDevice>& devices);

/// What must be set before a device of that kind can be used.
TroubleReport trouble_with_settings(DeviceKind kind, const DeviceSettings& settings);

}  // namespace hallux::simulator
