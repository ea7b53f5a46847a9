/// The record of an open serial arm: what its maker says of its links, encoders and motors.
/// Inside this corner only.
#pragma once

#include <filesystem>
#include <string_view>

#include "simulator/device/raw_hid_arm/arm_geometry.h"

namespace hallux::ui {

/// errors  FileRefused; scenarios::ScenarioError naming the place in the record
simulator::ArmGeometry read_arm_record(const std::filesystem::path& file);

/// errors  scenarios::ScenarioError naming the place in the record
simulator::ArmGeometry parse_arm_record(std::string_view text, std::string_view name);

}  // namespace hallux::ui
