#include "ui/jobs/cut_sweep.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/json_node.h"
#include "simulator/base/units.h"
#include "ui/jobs/files/read_small_file.h"

namespace hallux::ui {

namespace {

using scenarios::JsonNode;
using simulator::KerfPlane;
using simulator::Sweep;
using simulator::SweepPose;

constexpr std::size_t mebibytes_limit = 16;
constexpr std::size_t pose_limit = 100'000;
constexpr double length_limit_mm = 10'000.0;
constexpr double direction_length_min = 1.0e-6;
constexpr double blade_min_mm = 0.1, blade_max_mm = 1000.0;
constexpr double off_plane_limit_mm = 0.01;
constexpr double tilt_limit_degree = 0.1;

SweepPose pose_from(const JsonNode& node) {
  node.expect_keys({"tip", "direction"});
  const JsonNode direction_node = node.at("direction");
  const Vec3 direction = direction_node.vector(-length_limit_mm, length_limit_mm);
  const double length = std::sqrt(glm::dot(direction, direction));
  if (length < direction_length_min) direction_node.refuse_value("give a vector with a length");
  return {node.at("tip").vector(-length_limit_mm, length_limit_mm), direction / length};
}

Sweep sweep_from(const JsonNode& root) {
  root.expect_keys({"blade", "poses"});
  const JsonNode blade = root.at("blade");
  blade.expect_keys({"width_mm", "depth_mm"});
  Sweep sweep;
  sweep.width_mm = blade.at("width_mm").number(blade_min_mm, blade_max_mm);
  sweep.depth_mm = blade.at("depth_mm").number(blade_min_mm, blade_max_mm);
  for (const JsonNode& pose : root.at("poses").list(1, pose_limit)) {
    sweep.poses.push_back(pose_from(pose));
  }
  return sweep;
}

void expect_in_plane(const RigidTransform& asked_from_mesh, const SweepPose& pose,
                     const std::string& place) {
  const double off_mm = std::abs(transform_point(asked_from_mesh, pose.tip_in_mesh_mm).z);
  if (off_mm > off_plane_limit_mm) {
    throw CutInputError(place + ".tip: lies " + scenarios::text_of_number(off_mm) +
                        " mm off the plane; keep the blade in it within 0.01 mm");
  }
  const Vec3 direction = transform_direction(asked_from_mesh, pose.direction);
  if (std::abs(direction.z) > radian_from_degree(tilt_limit_degree)) {
    throw CutInputError(place +
                        ".direction: points out of the plane; keep it there within 0.1 degree");
  }
}

}  // namespace

Sweep parse_sweep(std::string_view text, std::string_view name) {
  try {
    const nlohmann::json document =
        scenarios::parse_bounded_json(text, name, mebibytes_limit << 20U);
    return sweep_from(JsonNode(document, name));
  } catch (const scenarios::ScenarioError& error) {
    throw CutInputError(error.what());
  }
}

Sweep read_sweep(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  try {
    return parse_sweep(read_small_file(file, mebibytes_limit, "name a sweep file"), name);
  } catch (const FileRefused& error) {
    throw CutInputError(error.what());
  }
}

void expect_in_plane(const Sweep& sweep, const KerfPlane& asked, std::string_view name) {
  const RigidTransform asked_from_mesh = inverse(asked.bone_from_kerf);
  for (std::size_t i = 0; i < sweep.poses.size(); ++i) {
    expect_in_plane(asked_from_mesh, sweep.poses[i],
                    std::string(name) + ": poses[" + std::to_string(i) + "]");
  }
}

}  // namespace hallux::ui
