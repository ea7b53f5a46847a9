#include "scenarios/read_parts.h"

#include "simulator/base/units.h"

namespace hallux::scenarios {

std::string read_origin(const JsonNode& node) {
  return node.at("origin").text(1, origin_bytes_max);
}

std::string read_title(const JsonNode& node) { return node.at("title").text(1, title_bytes_max); }

Vec3 read_direction(const JsonNode& node) {
  const Vec3 direction = node.vector(-1.0, 1.0);
  const double length = length_of(direction);
  if (length < 0.1) node.refuse_value("give the parts of a direction, the largest near 1");
  return direction / length;
}

/// Nothing was found on how much harder or softer living bone is to saw: half and half as much
/// again are ours.
PatientRequest read_bone_request(const JsonNode& node, std::span<const FootBone> bones) {
  PatientRequest patient;
  node.expect_keys({"bone", "length_mm", "edge_mm", "origin"}, {"eminence_mm", "bone_quality"});
  patient.bone = node.at("bone").name();
  const FootBone* const bone = find_foot_bone(patient.bone, bones);
  if (bone == nullptr) node.at("bone").refuse_value("use one of: " + names_of(bones));
  if (node.has("eminence_mm") != bone->has_eminence) {
    node.refuse_value(bone->has_eminence ? "give \"eminence_mm\""
                                         : "remove \"eminence_mm\": the " +
                                               std::string(bone->title) + " has none");
  }
  patient.length_mm = node.at("length_mm").number(bone->length_low_mm, bone->length_high_mm);
  if (bone->has_eminence) patient.eminence_mm = node.at("eminence_mm").number(0.0, 8.0);
  patient.edge_mm = node.at("edge_mm").number(0.2, 2.0);
  if (node.has("bone_quality")) patient.bone_quality = node.at("bone_quality").number(0.5, 1.5);
  patient.origin = read_origin(node);
  return patient;
}

/// The widest blades of the forefoot and hindfoot saws bound the ranges. Nobody would saw on with a
/// blade that takes less than a fifth, and none is sharper than a new one.
simulator::Saw read_saw(const JsonNode& node) {
  simulator::Saw saw;
  saw.blade.width_mm = node.at("width_mm").number(2.0, 30.0);
  saw.blade.depth_mm = node.at("depth_mm").number(5.0, 90.0);
  saw.blade.kerf_mm = node.at("kerf_mm").number(0.1, 2.0);
  saw.cycles_per_minute = node.at("cycles_per_minute").number(1000.0, 30000.0);
  saw.blade.thickness_mm = node.at("thickness_mm").number(0.1, 2.0);
  if (node.has("sharpness")) saw.sharpness = node.at("sharpness").number(0.2, 1.0);
  if (saw.blade.thickness_mm > saw.blade.kerf_mm) {
    node.at("kerf_mm").refuse_value("give at least the blade's thickness_mm");
  }
  return saw;
}

DangerZone read_danger_zone(const JsonNode& node, std::int32_t format) {
  const std::initializer_list<std::string_view> first{"from_landmark", "to_landmark"};
  const std::initializer_list<std::string_view> later{"from_landmark", "to_landmark", "bone"};
  node.expect_keys({"name", "title", "severity", "from_in_bone_mm", "to_in_bone_mm", "radius_mm",
                    "checked", "origin"},
                   format == 1 ? first : later);
  DangerZone zone{.name = node.at("name").name(),
                  .severity = node.at("severity").one_of({"critical", "major", "minor"}),
                  .from_in_bone_mm = node.at("from_in_bone_mm").vector(-200.0, 200.0),
                  .to_in_bone_mm = node.at("to_in_bone_mm").vector(-200.0, 200.0),
                  .radius_mm = node.at("radius_mm").number(0.1, 20.0),
                  .title = read_title(node),
                  .is_checked = node.at("checked").boolean(),
                  .origin = read_origin(node),
                  .bone = node.name_where_given("bone")};
  zone.from_landmark = node.name_where_given("from_landmark");
  zone.to_landmark = node.name_where_given("to_landmark");
  if (zone.from_in_bone_mm == zone.to_in_bone_mm && zone.from_landmark == zone.to_landmark) {
    node.at("to_in_bone_mm").refuse_value("give the other end of the structure");
  }
  return zone;
}

JointSurface read_joint_surface(const JsonNode& node, std::int32_t format) {
  const std::initializer_list<std::string_view> first{"offset_in_bone_mm"};
  const std::initializer_list<std::string_view> later{"offset_in_bone_mm", "bone"};
  node.expect_keys(
      {"name", "title", "around", "radius_mm", "facing_in_bone", "within_deg", "checked", "origin"},
      format == 1 ? first : later);
  return {.name = node.at("name").name(),
          .title = read_title(node),
          .around = node.at("around").name(),
          .offset_in_bone_mm = node.has("offset_in_bone_mm")
                                   ? node.at("offset_in_bone_mm").vector(-60.0, 60.0)
                                   : Vec3{0.0, 0.0, 0.0},
          .radius_mm = node.at("radius_mm").number(0.5, 40.0),
          .facing_in_bone = read_direction(node.at("facing_in_bone")),
          .within_rad = radian_from_degree(node.at("within_deg").number(1.0, 180.0)),
          .is_checked = node.at("checked").boolean(),
          .origin = read_origin(node),
          .bone = node.name_where_given("bone")};
}

}  // namespace hallux::scenarios
