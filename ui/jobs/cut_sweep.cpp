#include "ui/jobs/cut_sweep.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>

#include "simulator/base/units.h"
#include "ui/jobs/read_small_file.h"

namespace hallux::ui {

namespace {

using nlohmann::json;
using simulator::KerfField;
using simulator::KerfPlane;
using simulator::PlanarPose;

constexpr std::size_t mebibytes_limit = 16;
constexpr std::size_t pose_limit = 100'000;
constexpr double length_limit_mm = 10'000.0;
constexpr double off_plane_limit_mm = 0.01;
constexpr double tilt_limit_degree = 0.1;
/// A turning blade is followed in steps: the hull of two far turned blades is more than what lies between them.
constexpr double turn_step = 0.02;

/// One sweep file and the words for what is wrong in it.
class SweepReader {
 public:
  explicit SweepReader(std::string_view name) : name_(name) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw CutInputError(name_ + ": " + what);
  }
  void check_keys(const json& object, std::initializer_list<const char*> keys,
                  const std::string& place) const {
    if (!object.is_object()) refuse(place + " must be an object");
    for (const auto& item : object.items()) {
      const std::string& key = item.key();
      const bool is_known =
          std::any_of(keys.begin(), keys.end(), [&](const char* known) { return key == known; });
      if (!is_known) refuse(place + " has an unknown key \"" + key + "\"; remove it");
    }
    for (const char* key : keys) {
      if (!object.contains(key)) refuse(place + " lacks the key \"" + key + "\"; add it");
    }
  }
  double number(const json& value, double low, double high, const std::string& place) const {
    if (value.is_number()) {
      const double read = value.get<double>();
      if (read >= low && read <= high) return read;
    }
    refuse(place + " must be a number of millimetres from " + std::to_string(low) + " to " +
           std::to_string(high));
  }
  Vec3 vector(const json& value, double limit, const std::string& place) const {
    if (!value.is_array() || value.size() != 3) refuse(place + " must be a list of three numbers");
    return {number(value[0], -limit, limit, place), number(value[1], -limit, limit, place),
            number(value[2], -limit, limit, place)};
  }

 private:
  std::string name_;
};

SweepPose pose_from(const SweepReader& reader, const json& value, const std::string& place) {
  reader.check_keys(value, {"tip", "direction"}, place);
  SweepPose pose;
  pose.tip_in_mesh_mm = reader.vector(value["tip"], length_limit_mm, place + " tip");
  const Vec3 direction = reader.vector(value["direction"], length_limit_mm, place + " direction");
  const double length = std::sqrt(glm::dot(direction, direction));
  if (length < 1.0e-6) reader.refuse(place + " direction has no length");
  pose.direction = direction / length;
  return pose;
}

PlanarPose pose_in_plane(const KerfPlane& plane, const SweepPose& pose, const std::string& place) {
  const RigidTransform kerf_from_mesh = inverse(plane.bone_from_kerf);
  const Vec3 tip_mm = transform_point(kerf_from_mesh, pose.tip_in_mesh_mm);
  const Vec3 direction = transform_direction(kerf_from_mesh, pose.direction);
  if (std::abs(tip_mm.z) > off_plane_limit_mm) {
    throw CutInputError(place + " lies " + std::to_string(std::abs(tip_mm.z)) +
                        " mm off the plane; a blade stays in its plane within 0.01 mm");
  }
  if (std::abs(direction.z) > radian_from_degree(tilt_limit_degree)) {
    throw CutInputError(place +
                        " points out of the plane; directions stay in it within 0.1 degree");
  }
  const double length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  return {Vec2(tip_mm.x, tip_mm.y), Vec2(direction.x / length, direction.y / length)};
}

PlanarPose between(const PlanarPose& from, const PlanarPose& to, double part) {
  const Vec2 direction = from.direction + part * (to.direction - from.direction);
  return {from.tip_mm + part * (to.tip_mm - from.tip_mm),
          direction / std::sqrt(glm::dot(direction, direction))};
}

void stamp_motion(KerfField& field, const simulator::BladeSize& blade, const PlanarPose& from,
                  const PlanarPose& to) {
  simulator::FieldWindow changed;
  const Vec2 turn = to.direction - from.direction;
  const bool turns_back = glm::dot(from.direction, to.direction) < -0.99;
  const int steps =
      turns_back ? 1 : 1 + static_cast<int>(std::sqrt(glm::dot(turn, turn)) / turn_step);
  for (int i = 0; i < steps; ++i) {
    const PlanarPose start = i == 0 ? from : between(from, to, static_cast<double>(i) / steps);
    const PlanarPose end =
        i + 1 == steps ? to : between(from, to, static_cast<double>(i + 1) / steps);
    field.stamp(blade, start, end, changed);
  }
}

}  // namespace

Sweep parse_sweep(std::string_view text, std::string_view name) {
  const SweepReader reader(name);
  json value;
  try {
    value = json::parse(text);
  } catch (const json::parse_error& error) {
    reader.refuse("is not JSON (near byte " + std::to_string(error.byte) +
                  "); see docs/cutting.md for a sweep");
  } catch (const json::exception&) {
    reader.refuse("holds a number that no computer can represent; correct it");
  }
  reader.check_keys(value, {"blade", "poses"}, "the sweep");
  reader.check_keys(value["blade"], {"width_mm", "depth_mm"}, "blade");
  Sweep sweep;
  sweep.width_mm = reader.number(value["blade"]["width_mm"], 0.1, 1000.0, "blade width_mm");
  sweep.depth_mm = reader.number(value["blade"]["depth_mm"], 0.1, 1000.0, "blade depth_mm");
  const json& poses = value["poses"];
  if (!poses.is_array() || poses.empty())
    reader.refuse("poses must be a list of at least one pose");
  if (poses.size() > pose_limit) {
    reader.refuse("has " + std::to_string(poses.size()) + " poses; at most 100000 are read");
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    sweep.poses.push_back(pose_from(reader, poses[i], "pose " + std::to_string(i + 1)));
  }
  return sweep;
}

Sweep read_sweep(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  try {
    return parse_sweep(read_small_file(file, mebibytes_limit, "name a sweep file"), name);
  } catch (const FileRefused& error) {
    throw CutInputError(error.what());
  }
}

void stamp_sweep(KerfField& field, const KerfPlane& plane, const Sweep& sweep,
                 std::string_view name) {
  const simulator::BladeSize blade{sweep.width_mm, sweep.depth_mm, plane.thickness_mm};
  std::vector<PlanarPose> poses;
  for (std::size_t i = 0; i < sweep.poses.size(); ++i) {
    poses.push_back(pose_in_plane(plane, sweep.poses[i],
                                  std::string(name) + ": pose " + std::to_string(i + 1)));
  }
  stamp_motion(field, blade, poses.front(), poses.front());
  for (std::size_t i = 1; i < poses.size(); ++i) {
    stamp_motion(field, blade, poses[i - 1], poses[i]);
  }
}

}  // namespace hallux::ui
