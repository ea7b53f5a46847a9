// Points and directions are kept in the frame of the bone that they were made on; who asks for
// them from another bone is told them through the foot. On one bone nothing is converted, so what
// a scenario places there is to the bit what it says.
#include "scenarios/geometry/ground.h"

#include <optional>

#include "scenarios/geometry/geometry_order.h"
#include "scenarios/geometry/outer_surface.h"
#include "scenarios/geometry/part_path.h"
#include "simulator/base/check.h"
#include "simulator/base/elementary.h"

namespace hallux::scenarios {
namespace {

constexpr std::string_view foot_prefix = "foot_";

/// Along the axes of a frame with x distal, y dorsal, z lateral; nothing for another name.
std::optional<Vec3> axis_named(std::string_view name) {
  if (name == "distal") return Vec3{1.0, 0.0, 0.0};
  if (name == "proximal") return Vec3{-1.0, 0.0, 0.0};
  if (name == "dorsal") return Vec3{0.0, 1.0, 0.0};
  if (name == "plantar") return Vec3{0.0, -1.0, 0.0};
  if (name == "lateral") return Vec3{0.0, 0.0, 1.0};
  if (name == "medial") return Vec3{0.0, 0.0, -1.0};
  return std::nullopt;
}

}  // namespace

Vec3 unit_or_refuse(const Vec3& direction, const std::string& path, std::string_view what,
                    std::string_view mend) {
  const double length = length_of(direction);
  if (!(length > direction_length_min)) {
    throw ScenarioError(path + ": " + std::string(what) + "; " + std::string(mend));
  }
  return direction / length;
}

Ground::Ground(const Scenario& scenario, const simulator::Bones& bones)
    : scenario_(scenario), bones_(bones) {
  const std::size_t asked = 1 + scenario.further_bones.size();
  if (bones.size() != asked) {
    throw ScenarioError(scenario.name + ": patient: has " + std::to_string(asked) +
                        " bones, and the plan was asked for " + std::to_string(bones.size()) +
                        "; plan it on all of them");
  }
  for (const GeometryEntry& entry :
       geometry_order({scenario.points, scenario.directions}, scenario.name)) {
    if (entry.is_point) {
      const NamedPoint& point = scenario.points[entry.index];
      lay(point, part_path(scenario, "points", entry.index, point.name));
    } else {
      const NamedDirection& direction = scenario.directions[entry.index];
      lay(direction, part_path(scenario, "directions", entry.index, direction.name));
    }
  }
}

std::size_t Ground::bone_index(std::string_view name) const noexcept {
  if (name.empty() || name == scenario_.patient.bone) return 0;
  for (std::size_t i = 0; i < scenario_.further_bones.size(); ++i) {
    if (scenario_.further_bones[i].bone == name) return i + 1;
  }
  CHECK(false);
  return 0;
}

Vec3 Ground::moved_point(const Vec3& point_mm, std::size_t from_bone, std::size_t to_bone) const {
  if (from_bone == to_bone) return point_mm;
  return transform_point(
      inverse(bones_[to_bone].world_from_bone) * bones_[from_bone].world_from_bone, point_mm);
}

Vec3 Ground::moved_direction(const Vec3& direction, std::size_t from_bone,
                             std::size_t to_bone) const {
  if (from_bone == to_bone) return direction;
  return transform_direction(
      inverse(bones_[to_bone].world_from_bone) * bones_[from_bone].world_from_bone, direction);
}

Vec3 Ground::point(const std::string& name, std::size_t bone, const std::string& path) const {
  if (const auto found = points_.find(name); found != points_.end())
    return moved_point(found->second.in_bone, found->second.bone, bone);
  if (const std::optional<Vec3> landmark = simulator::find_landmark(bones_[bone], name))
    return *landmark;
  std::string known;
  for (const simulator::Landmark& landmark : bones_[bone].landmarks)
    known += (known.empty() ? "" : ", ") + landmark.name;
  for (const NamedPoint& named : scenario_.points) known += ", " + named.name;
  throw ScenarioError(path + ": the bone \"" + bones_[bone].name + "\" has no landmark \"" + name +
                      "\"; use one of: " + known);
}

Vec3 Ground::direction(const std::string& name, std::size_t bone, const std::string& path) const {
  if (const auto found = directions_.find(name); found != directions_.end())
    return moved_direction(found->second.in_bone, found->second.bone, bone);
  if (const std::optional<Vec3> axis = axis_named(name)) return *axis;
  if (name.starts_with(foot_prefix)) {
    if (const std::optional<Vec3> axis = axis_named(name.substr(foot_prefix.size())))
      return transform_direction(inverse(bones_[bone].world_from_bone), *axis);
  }
  std::string known;
  for (const std::string_view axis : axis_names())
    known.append(known.empty() ? "" : ", ").append(axis);
  for (const NamedDirection& named : scenario_.directions) known += ", " + named.name;
  throw ScenarioError(path + ": there is no direction \"" + name + "\"; use one of: " + known);
}

void Ground::add_line(const std::string& name, std::size_t bone, const Vec3& point_mm,
                      const Vec3& direction) {
  points_[name] = {bone, point_mm};
  directions_[name] = {bone, direction};
}

void Ground::lay(const NamedPoint& point, const std::string& path) {
  for (const simulator::Bone& bone : bones_) {
    if (!simulator::find_landmark(bone, point.name)) continue;
    throw ScenarioError(path + ": the bone \"" + bone.name +
                        "\" has a landmark of that name; choose another name");
  }
  const std::size_t bone = bone_index(point.bone);
  points_[point.name] = {bone, made(point, bone, path)};
}

Vec3 Ground::made(const NamedPoint& asked, std::size_t bone, const std::string& path) const {
  const Vec3 from_mm = point(asked.from, bone, path);
  switch (asked.kind) {
    case PointKind::Moved:
      break;
    case PointKind::Between:
      return from_mm + asked.share * (point(asked.to, bone, path) - from_mm);
    case PointKind::OnSurface:
      if (const std::optional<Vec3> found =
              last_on_ray(bones_[bone].outer, from_mm, direction(asked.along, bone, path)))
        return *found;
      throw ScenarioError(path + ": the way from \"" + asked.from + "\" along \"" + asked.along +
                          "\" misses the bone \"" + bones_[bone].name +
                          "\"; mend on_surface.from or on_surface.along");
  }
  Vec3 moved_mm = from_mm;
  for (const MoveAlong& move : asked.moves) moved_mm += move.mm * direction(move.along, bone, path);
  return moved_mm;
}

void Ground::lay(const NamedDirection& direction, const std::string& path) {
  const std::size_t bone = bone_index(direction.bone);
  directions_[direction.name] = {bone, made(direction, bone, path)};
}

Vec3 Ground::made(const NamedDirection& asked, std::size_t bone, const std::string& path) const {
  if (asked.kind == DirectionKind::Between) {
    return unit_or_refuse(
        point(asked.second, bone, path) - point(asked.first, bone, path), path,
        "the points \"" + asked.first + "\" and \"" + asked.second + "\" coincide",
        "name points that lie apart");
  }
  const Vec3 first = direction(asked.first, bone, path);
  const Vec3 second = direction(asked.second, bone, path);
  const std::string parallel =
      "the directions \"" + asked.first + "\" and \"" + asked.second + "\" are parallel";
  constexpr std::string_view mend = "name directions that part";
  if (asked.kind == DirectionKind::SquareToBoth)
    return unit_or_refuse(glm::cross(first, second), path, parallel, mend);
  if (asked.kind == DirectionKind::LaidSquare)
    return unit_or_refuse(first - glm::dot(first, second) * second, path, parallel, mend);
  const double cosine = elementary::cos(asked.turn_rad), sine = elementary::sin(asked.turn_rad);
  const double along = glm::dot(first, second);
  return cosine * first + sine * glm::cross(second, first) + (1.0 - cosine) * along * second;
}

}  // namespace hallux::scenarios
