/// What is set for the devices of this station, kept in `devices.json` beside the database.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "simulator/device/station/station_settings.h"

namespace hallux::ui {

/// What can be set for a device, for whoever asks.
struct DeviceKey {
  std::string_view name;
  /// Of the kinds that have it; empty: all.
  std::string_view kind;
  std::string_view what;
};
std::span<const DeviceKey> device_keys() noexcept;

/// Nothing is set where there is no file. A record of a geometry that cannot be used is kept as a
/// fault of its device.
/// errors  FileRefused, scenarios::ScenarioError: the file is not what is kept there
simulator::StationSettings read_devices(const std::filesystem::path& data_directory);

/// Sets one value for a device or a kind and keeps it; an empty value unsets it. The directory is
/// made where it is missing.
/// errors  scenarios::ScenarioError naming key and value: no such kind, no such key, out of bounds,
///         a file that is no firmware or no record; OutputError; database::DatabaseError where no
///         directory can be made
void set_device(const std::filesystem::path& data_directory, const std::string& id,
                const std::string& key, const std::string& value);

}  // namespace hallux::ui
