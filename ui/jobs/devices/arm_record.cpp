#include "ui/jobs/devices/arm_record.h"

#include <algorithm>

#include "scenarios/json_node.h"
#include "ui/jobs/files/read_small_file.h"

namespace hallux::ui {

namespace {

using scenarios::JsonNode;

constexpr double length_max_mm = 2000.0, counts_max = 1.0e6, torque_max = 1.0e5;

template <typename Value, std::size_t Count>
void read_row(const JsonNode& node, std::array<Value, Count>& row, double low, double high) {
  const std::vector<JsonNode> values = node.list(Count, Count);
  for (std::size_t i = 0; i < Count; ++i) row[i] = static_cast<Value>(values[i].number(low, high));
}

void read_links(const JsonNode& node, simulator::ArmGeometry& arm) {
  node.expect_keys({"base_mm", "first_mm", "second_mm", "middle_mm", "workspace_radius_mm"});
  arm.base_mm = node.at("base_mm").number(0.0, length_max_mm);
  arm.first_mm = node.at("first_mm").number(0.0, length_max_mm);
  arm.second_mm = node.at("second_mm").number(0.0, length_max_mm);
  arm.middle_mm = node.at("middle_mm").vector(-length_max_mm, length_max_mm);
  arm.workspace_radius_mm = node.at("workspace_radius_mm").number(0.0, length_max_mm);
}

void read_joints(const JsonNode& node, simulator::ArmGeometry& arm) {
  node.expect_keys({"capstan_mm", "sector_mm", "counts_per_turn", "direction", "at_rest"});
  arm.capstan_mm = node.at("capstan_mm").number(0.0, length_max_mm);
  read_row(node.at("sector_mm"), arm.sector_mm, 0.0, length_max_mm);
  read_row(node.at("counts_per_turn"), arm.counts_per_turn, 0.0, counts_max);
  read_row(node.at("direction"), arm.direction, -1.0, 1.0);
  read_row(node.at("at_rest"), arm.at_rest, -32768.0, 32767.0);
}

void read_motors(const JsonNode& node, simulator::ArmGeometry& arm) {
  node.expect_keys({"torque_newton_mm_per_ampere", "current_ampere", "force_newton",
                    "continuous_force_newton", "stiffness_newton_per_mm",
                    "damping_newton_s_per_mm"});
  read_row(node.at("torque_newton_mm_per_ampere"), arm.torque_newton_mm_per_ampere, 0.0,
           torque_max);
  arm.current_ampere = node.at("current_ampere").number(0.0, 20.0);
  arm.force_newton = node.at("force_newton").number(0.0, 50.0);
  arm.continuous_force_newton = node.at("continuous_force_newton").number(0.0, 50.0);
  arm.stiffness_newton_per_mm = node.at("stiffness_newton_per_mm").number(0.0, 20.0);
  arm.damping_newton_s_per_mm = node.at("damping_newton_s_per_mm").number(0.0, 0.1);
}

}  // namespace

simulator::ArmGeometry parse_arm_record(std::string_view text, std::string_view name) {
  const nlohmann::json document = scenarios::parse_bounded_json(text, name);
  const JsonNode root(document, name);
  root.expect_keys({"name", "links", "joints", "motors"});
  simulator::ArmGeometry arm;
  arm.name = root.at("name").text(1, 64);
  read_links(root.at("links"), arm);
  read_joints(root.at("joints"), arm);
  read_motors(root.at("motors"), arm);
  const std::string fault = fault_in(arm);
  if (!fault.empty()) scenarios::refuse(name, "", fault, "correct the record");
  return arm;
}

simulator::ArmGeometry read_arm_record(const std::filesystem::path& file) {
  const std::string text =
      read_small_file(file, 1, "give the record of the arm's geometry (docs/haptics.md, Devices)");
  return parse_arm_record(text, file.filename().string());
}

}  // namespace hallux::ui
