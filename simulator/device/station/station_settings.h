/// What is set for the devices of one machine: where their firmware and records lie, and how they
/// are held. Plain data; whoever keeps it reads it from a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "simulator/device/raw_hid_arm/arm_geometry.h"

namespace hallux::simulator {

struct DeviceSettings {
  /// Falcon.
  std::filesystem::path firmware = {};
  std::optional<double> counts_per_newton_metre = std::nullopt;
  /// Open serial arm: the record's file, and what it says; where that cannot be used, why.
  std::filesystem::path geometry_file = {};
  std::optional<ArmGeometry> geometry = std::nullopt;
  std::string geometry_fault = {};
  /// Inverse3: where its service listens on this machine, if not where it usually does.
  std::optional<std::uint16_t> service_port = std::nullopt;
  /// World millimetres for one of the device.
  std::optional<double> motion_scale = std::nullopt;
  /// Of what the device gives, at most.
  std::optional<double> force_share = std::nullopt;
};

/// How a person holds whatever operates, over what is set for the station.
struct HandChoice {
  std::optional<double> motion_scale = std::nullopt, force_share = std::nullopt;
};

/// How a device is held.
struct Hold {
  /// World millimetres for one of the device.
  double motion_scale = 1.0;
  /// Of what the device gives, at most [0, 1].
  double force_share = 1.0;
};

/// A person's scale before the station's; of the force the lesser of both.
Hold hold_of(const DeviceSettings& set, const HandChoice& own) noexcept;

struct StationSettings {
  /// By the device's id, or by its kind's for all of that kind.
  std::map<std::string, DeviceSettings> devices = {};

  /// What is set for that device, its own before its kind's.
  DeviceSettings of(const std::string& id, const std::string& kind) const;
};

}  // namespace hallux::simulator
