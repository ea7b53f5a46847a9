#include "simulator/device/station/device_kind.h"

#include <algorithm>
#include <array>

#include "simulator/device/falcon/falcon_driver.h"
#include "simulator/device/raw_hid_arm/arm_driver.h"
#include "simulator/device/space_mouse/space_mouse_driver.h"

namespace hallux::simulator {

namespace {

constexpr std::array<KindFacts, 8> kinds{{
    {DeviceKind::Mouse, "mouse", "Mouse and keyboard", "mouse", "window"},
    {DeviceKind::Falcon, "falcon", "Novint Falcon", "arm3", "libusb"},
    {DeviceKind::RawHidArm, "raw_hid_arm", "Open serial arm (WoodenHaptics, Polhem)", "arm6",
     "hidapi"},
    {DeviceKind::Inverse3, "inverse3", "Haply Inverse3", "arm3", "libwebsockets"},
    {DeviceKind::SpaceMouse, "space_mouse", "3Dconnexion SpaceMouse", "rate", "hidapi"},
    {DeviceKind::Touch, "touch", "3D Systems Touch", "", ""},
    {DeviceKind::ForceDimension, "force_dimension", "Force Dimension omega, sigma, lambda", "", ""},
    {DeviceKind::FireWireOmni, "omni", "Phantom Omni (FireWire)", "", ""},
}};

// source  docs/haptics.md, Devices
constexpr std::uint16_t force_dimension = 0x1451, systems_3d = 0x2988, systems_3d_swapped = 0x0301;
constexpr std::array<std::uint16_t, 4> vendors{falcon_vendor, force_dimension, systems_3d,
                                               systems_3d_swapped};

bool is_arm(std::uint16_t vendor, std::uint16_t product, const HidUsage& usage) noexcept {
  const bool is_older = vendor == older_arm_vendor && product == older_arm_product;
  return is_older ||
         (vendor == arm_vendor && product == arm_product && usage.page == arm_usage_page);
}

}  // namespace

const KindFacts& facts_of(DeviceKind kind) noexcept {
  return kinds[static_cast<std::size_t>(kind)];
}

const KindFacts* kind_named(std::string_view id) noexcept {
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const KindFacts& each) { return each.id == id; });
  return found == kinds.end() ? nullptr : &*found;
}

const KindFacts* hid_kind(std::uint16_t vendor, std::uint16_t product,
                          const HidUsage& usage) noexcept {
  if (is_space_mouse(vendor, product, usage)) return &facts_of(DeviceKind::SpaceMouse);
  if (is_arm(vendor, product, usage)) return &facts_of(DeviceKind::RawHidArm);
  if (vendor == systems_3d) return &facts_of(DeviceKind::Touch);
  return nullptr;
}

const KindFacts* usb_kind(std::uint16_t vendor, std::uint16_t product) noexcept {
  if (vendor == falcon_vendor)
    return product == falcon_product ? &facts_of(DeviceKind::Falcon) : nullptr;
  if (vendor == force_dimension) return &facts_of(DeviceKind::ForceDimension);
  const bool is_touch = (vendor == systems_3d && product == 0x0302) ||
                        (vendor == systems_3d_swapped && product == systems_3d);
  return is_touch ? &facts_of(DeviceKind::Touch) : nullptr;
}

std::span<const std::uint16_t> usb_vendors() noexcept { return vendors; }

}  // namespace hallux::simulator
