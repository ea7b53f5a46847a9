#include "simulator/device/station/found_device.h"

#include <algorithm>
#include <tuple>

#include "simulator/device/bus/service_library.h"
#include "simulator/device/falcon/falcon_firmware.h"

namespace hallux::simulator {

namespace {

/// What of a serial can be typed.
std::string typed(const std::string& serial) {
  std::string letters;
  for (const char letter : serial) {
    const bool is_plain = (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
                          (letter >= 'A' && letter <= 'Z') || letter == '.' || letter == '_';
    if (is_plain) letters += letter;
  }
  return letters;
}

FoundDevice found(const KindFacts& kind, const PluggedDevice& plugged) {
  FoundDevice device;
  device.kind = kind.kind;
  device.name = plugged.product_name.empty() ? std::string(kind.name) : plugged.product_name;
  device.address = plugged.node;
  device.serial = typed(plugged.serial);
  device.bus_path = plugged.bus_path;
  device.vendor = plugged.vendor;
  device.product = plugged.product;
  return device;
}

std::size_t count_like(const std::vector<FoundDevice>& devices, const FoundDevice& like,
                       bool with_serial) {
  return static_cast<std::size_t>(
      std::count_if(devices.begin(), devices.end(), [&](const FoundDevice& each) {
        return each.kind == like.kind && (!with_serial || each.serial == like.serial);
      }));
}

/// A closed protocol cannot be helped, a right can: the first that is true is told.
TroubleReport trouble_of(const FoundDevice& device, const DeviceSettings& settings) {
  // What a service speaks for has no node, and needs no setting but the service's.
  if (device.service_port != 0) return device.trouble;
  if (facts_of(device.kind).device_class.empty())
    return {DeviceTrouble::ClosedProtocol, device.address, {}};
  if (TroubleReport trouble = trouble_with_node(device.address)) return trouble;
  return trouble_with_settings(device.kind, settings);
}

std::string service_address(std::uint16_t port) { return "ws://127.0.0.1:" + std::to_string(port); }

/// Those that the service of the Inverse3 has. Nobody who has none wants to read that it is away:
/// it is told where something was set for one.
void add_served(std::vector<FoundDevice>& devices, InverseService& inverse,
                const StationSettings& settings) {
  const std::uint16_t port = service_port(settings);
  const InverseList list = inverse.look(port);
  for (const InverseArm& arm : list.arms) {
    FoundDevice device = unserved_inverse(port);
    device.serial = device.bus_path = arm.id;
    device.trouble = trouble_with_inverse(arm);
    devices.push_back(std::move(device));
  }
  const std::string id(facts_of(DeviceKind::Inverse3).id);
  const auto set = settings.devices.lower_bound(id);
  const bool is_set = set != settings.devices.end() && set->first.starts_with(id);
  const bool is_away = list.trouble.trouble == DeviceTrouble::NoService;
  if (!list.trouble || (is_away && !is_set)) return;
  FoundDevice device = unserved_inverse(port);
  device.trouble = list.trouble;
  devices.push_back(std::move(device));
}

}  // namespace

DeviceSettings StationSettings::of(const std::string& id, const std::string& kind) const {
  const auto own = devices.find(id);
  if (own != devices.end()) return own->second;
  const auto shared = devices.find(kind);
  return shared == devices.end() ? DeviceSettings{} : shared->second;
}

Hold hold_of(const DeviceSettings& set, const HandChoice& own) noexcept {
  const Hold usual;
  return {own.motion_scale.value_or(set.motion_scale.value_or(usual.motion_scale)),
          std::min(own.force_share.value_or(usual.force_share),
                   set.force_share.value_or(usual.force_share))};
}

TroubleReport trouble_with_settings(DeviceKind kind, const DeviceSettings& settings) {
  if (kind == DeviceKind::Falcon) {
    if (settings.firmware.empty()) return {DeviceTrouble::NoFirmware, {}, {}};
    const FalconFirmware firmware = read_falcon_firmware(settings.firmware);
    if (!firmware.fault) return {};
    return {DeviceTrouble::BadFirmware, settings.firmware.string(),
            "byte " + std::to_string(firmware.fault->byte) + ": " + firmware.fault->what};
  }
  if (kind == DeviceKind::RawHidArm && !settings.geometry_fault.empty())
    return {DeviceTrouble::BadRecord, settings.geometry_file.string(), settings.geometry_fault};
  return {};
}

const FoundDevice* device_with(const std::vector<FoundDevice>& devices, const std::string& id) {
  const auto found = std::find_if(devices.begin(), devices.end(),
                                  [&](const FoundDevice& each) { return each.id == id; });
  return found == devices.end() ? nullptr : &*found;
}

void name_apart(std::vector<FoundDevice>& devices) {
  for (FoundDevice& device : devices) {
    device.id = facts_of(device.kind).id;
    if (count_like(devices, device, false) == 1) continue;
    if (!device.serial.empty()) device.id += '-' + device.serial;
    if (count_like(devices, device, true) > 1) device.id += '@' + device.bus_path;
  }
}

std::vector<DeviceLibrary> device_libraries() {
  return {{"hidapi", hid_library_version()},
          {"libusb", usb_library_version()},
          {"libwebsockets", service_library_version()}};
}

std::uint16_t service_port(const StationSettings& settings) {
  const std::string id(facts_of(DeviceKind::Inverse3).id);
  return settings.of(id, id).service_port.value_or(inverse_port);
}

FoundDevice unserved_inverse(std::uint16_t port) {
  FoundDevice device;
  device.kind = DeviceKind::Inverse3;
  device.id = facts_of(device.kind).id;
  device.name = facts_of(device.kind).name;
  device.address = service_address(port);
  device.service_port = port;
  device.trouble = {DeviceTrouble::NoService, std::to_string(port), {}};
  return device;
}

std::vector<FoundDevice> find_devices(Buses& buses, const StationSettings& settings) {
  std::vector<FoundDevice> devices;
  for (const std::uint16_t vendor : usb_vendors())
    for (const PluggedDevice& each : buses.usb.plugged(vendor))
      if (const KindFacts* kind = usb_kind(each.vendor, each.product))
        devices.push_back(found(*kind, each));
  for (const PluggedHid& each : buses.hid.plugged()) {
    const KindFacts* kind = hid_kind(each.device.vendor, each.device.product, each.usage);
    if (kind == nullptr) continue;
    devices.push_back(found(*kind, each.device));
    devices.back().axis_limit = each.axis_limit;
  }
  add_served(devices, buses.inverse, settings);
  // The same order whatever the buses answer first.
  std::stable_sort(devices.begin(), devices.end(), [](const FoundDevice& a, const FoundDevice& b) {
    return std::tie(a.kind, a.serial, a.bus_path) < std::tie(b.kind, b.serial, b.bus_path);
  });
  name_apart(devices);
  for (FoundDevice& each : devices)
    each.trouble = trouble_of(each, settings.of(each.id, std::string(facts_of(each.kind).id)));
  FoundDevice mouse;
  mouse.id = facts_of(DeviceKind::Mouse).id;
  mouse.name = facts_of(DeviceKind::Mouse).name;
  devices.insert(devices.begin(), std::move(mouse));
  return devices;
}

}  // namespace hallux::simulator
