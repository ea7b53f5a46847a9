#include "ui/jobs/plan_file.h"

#include <nlohmann/json.hpp>

#include "simulator/base/units.h"
#include "ui/jobs/geometry_json.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;
using scenarios::FaceKind;
using scenarios::Plan;
using scenarios::PlannedCut;
using scenarios::PlannedHinge;
using scenarios::Scenario;

/// As a scenario's file says it.
const char* name_of(FaceKind kind) noexcept {
  if (kind == FaceKind::Turned) return "turned";
  if (kind == FaceKind::AlongAxis) return "along_axis";
  return kind == FaceKind::Transverse ? "transverse" : "through_hinge";
}

ordered_json landmarks_json(const simulator::Bone& bone) {
  // By name: a bone from elsewhere may have many.
  nlohmann::json landmarks = nlohmann::json::object();
  for (const simulator::Landmark& landmark : bone.landmarks) {
    const Vec3& point = landmark.point_in_bone_mm;
    landmarks[landmark.name] = {point.x, point.y, point.z};
  }
  return landmarks;
}

/// A face of format 1 across the bone runs out of it nowhere that is planned, unless it stops at a
/// hinge.
ordered_json exit_json(const PlannedCut& cut) {
  if (!cut.has_exit) return nullptr;
  return vector_json(cut.exit_point_in_bone_mm);
}

ordered_json cut_json(const PlannedCut& cut, const scenarios::ReferenceCut& reference) {
  return {{"name", cut.name},
          {"title", reference.title},
          {"normal", vector_json(cut.face.normal)},
          {"offset_mm", cut.face.offset_mm},
          {"axis", vector_json(cut.axis)},
          {"contains", vector_json(cut.contained_in_bone)},
          {"entry_in_bone_mm", vector_json(cut.entry_point_in_bone_mm)},
          {"exit_in_bone_mm", exit_json(cut)},
          {"depth_in_bone_mm", vector_json(cut.depth_point_in_bone_mm)},
          {"kind", name_of(reference.face.kind)},
          {"hinge", cut.hinge.empty() ? ordered_json(nullptr) : ordered_json(cut.hinge)}};
}

ordered_json hinge_json(const PlannedHinge& hinge, double target_low_mm) {
  const simulator::HingeLine& line = hinge.bridge.line;
  return {{"name", hinge.name},
          {"first_cut", hinge.first_cut},
          {"second_cut", hinge.second_cut},
          {"point_in_bone_mm", vector_json(line.point_in_bone_mm)},
          {"axis", vector_json(line.axis)},
          {"outward", vector_json(line.outward)},
          {"wedge_deg", degree_from_radian(hinge.wedge_rad)},
          {"thickness_mm", line.thickness_mm},
          {"target_mm", {target_low_mm, hinge.target_high_mm}}};
}

ordered_json zone_json(const scenarios::PlannedZone& zone, const std::string& severity) {
  return {{"name", zone.name},
          {"severity", severity},
          {"from_in_bone_mm", vector_json(zone.capsule.from_in_bone_mm)},
          {"to_in_bone_mm", vector_json(zone.capsule.to_in_bone_mm)},
          {"radius_mm", zone.capsule.radius_mm}};
}

ordered_json joint_json(const scenarios::PlannedJointSurface& planned,
                        const scenarios::JointSurface& surface) {
  return {{"name", planned.name},
          {"centre_in_bone_mm", vector_json(planned.centre_in_bone_mm)},
          {"radius_mm", surface.radius_mm},
          {"facing_in_bone", vector_json(surface.facing_in_bone)},
          {"within_deg", degree_from_radian(surface.within_rad)}};
}

ordered_json blade_json(const simulator::Blade& blade) {
  return {{"width_mm", blade.width_mm},
          {"depth_mm", blade.depth_mm},
          {"thickness_mm", blade.thickness_mm},
          {"kerf_mm", blade.kerf_mm}};
}

}  // namespace

std::string plan_file(const Scenario& scenario, const simulator::Bone& bone, const Plan& plan) {
  // A plan's parts stand in the order of the scenario's.
  ordered_json cuts = ordered_json::array(), hinges = cuts, zones = cuts, joints = cuts;
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    cuts.push_back(cut_json(plan.cuts[i], scenario.cuts[i]));
  }
  for (std::size_t i = 0; i < plan.hinges.size(); ++i) {
    hinges.push_back(hinge_json(plan.hinges[i], scenario.hinges[i].target_low_mm));
  }
  for (std::size_t i = 0; i < plan.danger_zones.size(); ++i) {
    zones.push_back(zone_json(plan.danger_zones[i], scenario.danger_zones[i].severity));
  }
  for (std::size_t i = 0; i < plan.joint_surfaces.size(); ++i) {
    joints.push_back(joint_json(plan.joint_surfaces[i], scenario.joint_surfaces[i]));
  }
  const ordered_json json{{"format", plan_file_format},
                          {"scenario", scenario.name},
                          {"scenario_version", scenario.version},
                          {"bone", bone.name},
                          {"landmarks", landmarks_json(bone)},
                          {"cuts", std::move(cuts)},
                          {"hinges", std::move(hinges)},
                          {"danger_zones", std::move(zones)},
                          {"joint_surfaces", std::move(joints)},
                          {"world_from_bone", matrix_json(bone.world_from_bone)},
                          {"blade", blade_json(scenario.saw.blade)}};
  // The names of a bone from elsewhere may be no UTF-8.
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace hallux::ui
