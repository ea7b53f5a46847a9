/// The kinds of device that Hallux knows, those included that nobody may speak with: their makers
/// keep the protocol closed, and whoever has one wants to know why it does nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "simulator/device/bus/hid_descriptor.h"
#include "simulator/device/port/device_trouble.h"

namespace hallux::simulator {

enum class DeviceKind : std::uint8_t {
  Mouse,
  Falcon,
  RawHidArm,
  Inverse3,
  SpaceMouse,
  // Closed.
  Touch,
  ForceDimension,
  FireWireOmni
};

/// What is the same for each device of a kind.
struct KindFacts {
  DeviceKind kind = DeviceKind::Mouse;
  /// In the ids that people type.
  std::string_view id;
  std::string_view name;
  /// Comparisons of scores stay within a class; empty for what cannot be used.
  std::string_view device_class;
  /// Through which it is reached.
  std::string_view library;
};

const KindFacts& facts_of(DeviceKind kind) noexcept;
/// Nullptr where none has that id.
const KindFacts* kind_named(std::string_view id) noexcept;

/// By USB's numbers and what it says it is for; nullptr: none of ours.
const KindFacts* hid_kind(std::uint16_t vendor, std::uint16_t product,
                          const HidUsage& usage) noexcept;
const KindFacts* usb_kind(std::uint16_t vendor, std::uint16_t product) noexcept;
/// Of whose USB devices some are ours.
std::span<const std::uint16_t> usb_vendors() noexcept;

}  // namespace hallux::simulator
