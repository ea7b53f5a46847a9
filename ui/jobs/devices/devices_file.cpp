#include "ui/jobs/devices/devices_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "database/store/files.h"
#include "scenarios/json_node.h"
#include "scenarios/scenario_error.h"
#include "simulator/device/falcon/falcon_firmware.h"
#include "simulator/device/station/device_kind.h"
#include "ui/jobs/devices/arm_record.h"
#include "ui/jobs/devices/device_sentences.h"
#include "ui/jobs/files/output_file.h"
#include "ui/jobs/files/read_small_file.h"

namespace hallux::ui {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using scenarios::JsonNode;
using simulator::DeviceSettings;

constexpr const char* file_name = "devices.json";
constexpr std::size_t id_letters_max = 160, path_letters_max = 4096;

constexpr std::string_view firmware_key = "firmware",
                           force_constant_key = "counts_per_newton_metre",
                           geometry_key = "geometry", motion_key = "motion_scale",
                           force_key = "force_share", port_key = "service_port";
constexpr std::array<DeviceKey, 6> keys{{
    {firmware_key, "falcon", "the file with its firmware, from its maker's own program"},
    {force_constant_key, "falcon", "what its motors make of a newton metre, 1000 to 20000"},
    {geometry_key, "raw_hid_arm", "the file with the record of its geometry"},
    {port_key, "inverse3", "where its service listens on this machine, 1024 to 65535"},
    {motion_key, "", "millimetres of the saw for one of the hand, 0.25 to 4"},
    {force_key, "", "how much of the force that it can give it is given, 0 to 1"},
}};

/// Of a number that can be set.
struct Bounds {
  double low = 0.0, high = 0.0;
};
Bounds bounds_of(std::string_view key) noexcept {
  if (key == force_constant_key) return {1000.0, 20000.0};
  if (key == port_key) return {1024.0, 65535.0};
  return key == motion_key ? Bounds{0.25, 4.0} : Bounds{0.0, 1.0};
}
bool is_path(std::string_view key) noexcept { return key == firmware_key || key == geometry_key; }

DeviceSettings settings_from(const JsonNode& node) {
  node.expect_keys(
      {}, {firmware_key, force_constant_key, geometry_key, motion_key, force_key, port_key});
  const auto path = [&](std::string_view key) {
    return node.has(key) ? fs::path(node.at(key).text(1, path_letters_max)) : fs::path();
  };
  const auto number = [&](std::string_view key) -> std::optional<double> {
    if (!node.has(key)) return std::nullopt;
    const Bounds bounds = bounds_of(key);
    return node.at(key).number(bounds.low, bounds.high);
  };
  DeviceSettings settings;
  settings.firmware = path(firmware_key);
  settings.counts_per_newton_metre = number(force_constant_key);
  settings.geometry_file = path(geometry_key);
  if (const auto port = number(port_key)) settings.service_port = static_cast<std::uint16_t>(*port);
  settings.motion_scale = number(motion_key);
  settings.force_share = number(force_key);
  return settings;
}

/// A record that is wrong today may be right tomorrow: it is a fault of its device, not of the
/// file.
void read_geometry(DeviceSettings& settings) {
  if (settings.geometry_file.empty()) return;
  try {
    settings.geometry = read_arm_record(settings.geometry_file);
  } catch (const std::runtime_error& error) {
    settings.geometry_fault = error.what();
  }
}

ordered_json kept_in(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {{"devices", ordered_json::object()}};
  const std::string text = read_small_file(file, 1, "delete it and set the devices again");
  const std::string name = file.string();
  const nlohmann::json document = scenarios::parse_bounded_json(text, name);
  const JsonNode root(document, name);
  root.expect_keys({"devices"});
  return ordered_json::parse(text);
}

[[noreturn]] void refuse_value(const std::string& id, const std::string& key,
                               const std::string& value, const std::string& what) {
  throw scenarios::ScenarioError(id + " " + key + " '" + value + "': " + what);
}

const DeviceKey& key_named(const std::string& id, const std::string& key) {
  const simulator::KindFacts* kind = kind_of_device(id);
  if (kind == nullptr || kind->device_class.empty() || kind->kind == simulator::DeviceKind::Mouse) {
    throw scenarios::ScenarioError(id +
                                   ": is no device that can be set; `hallux devices` lists them");
  }
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const DeviceKey& each) {
    return each.name == key && (each.kind.empty() || each.kind == kind->id);
  });
  if (found != keys.end() && found->name == port_key && id != kind->id) {
    throw scenarios::ScenarioError(id + ": one service speaks for all of its kind; set it for " +
                                   std::string(kind->id));
  }
  if (found != keys.end()) return *found;
  std::string all;
  for (const DeviceKey& each : keys) {
    if (!each.kind.empty() && each.kind != kind->id) continue;
    all += (all.empty() ? "" : ", ") + std::string(each.name);
  }
  throw scenarios::ScenarioError(id + ": '" + key + "' cannot be set for it; give one of " + all);
}

ordered_json number_from(const std::string& id, const std::string& key, const std::string& value) {
  const Bounds bounds = bounds_of(key);
  double number = 0.0;
  const auto read = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool is_whole = read.ec == std::errc() && read.ptr == value.data() + value.size();
  const bool is_fit = key != port_key || number == std::floor(number);
  if (!is_whole || !is_fit || !(number >= bounds.low && number <= bounds.high)) {
    refuse_value(id, key, value,
                 "give a number from " + scenarios::text_of_number(bounds.low) + " to " +
                     scenarios::text_of_number(bounds.high));
  }
  return number;
}

/// Kept as a whole path, and only where it can be used now.
ordered_json path_from(const std::string& id, const std::string& key, const std::string& value) {
  const fs::path file = fs::absolute(value);
  if (key == geometry_key) {
    static_cast<void>(read_arm_record(file));
  } else if (const auto fault = simulator::read_falcon_firmware(file).fault) {
    refuse_value(
        id, key, value,
        "byte " + std::to_string(fault->byte) + ": " + fault->what + "; give the firmware's file");
  }
  return file.string();
}

}  // namespace

std::span<const DeviceKey> device_keys() noexcept { return keys; }

simulator::StationSettings read_devices(const fs::path& data_directory) {
  const fs::path file = data_directory / file_name;
  simulator::StationSettings settings;
  const std::string name = file.string();
  const nlohmann::json kept = kept_in(file);
  const JsonNode root(kept, name);
  if (!kept["devices"].is_object()) root.at("devices").refuse_value("give an object by device");
  for (const auto& [id, value] : kept["devices"].items()) {
    DeviceSettings& own = settings.devices[id.substr(0, id_letters_max)];
    own = settings_from(root.at("devices").at(id));
    read_geometry(own);
  }
  return settings;
}

void set_device(const fs::path& data_directory, const std::string& id, const std::string& key,
                const std::string& value) {
  const DeviceKey& known = key_named(id, key);
  ordered_json kept = kept_in(data_directory / file_name);
  ordered_json& own = kept["devices"][id];
  if (value.empty()) {
    own.erase(key);
  } else {
    own[key] = is_path(known.name) ? path_from(id, key, value) : number_from(id, key, value);
  }
  if (own.empty()) kept["devices"].erase(id);
  database::make_private_directory(data_directory);
  replace_own_file(data_directory / file_name, kept.dump(1) + "\n");
}

}  // namespace hallux::ui
