// Lists of what a plan holds, each in the order of the scenario, so that an index, an event's place
// on the tray and a name all lead to the same entry. What a scenario of format 1 has none of is an
// empty list, not a missing key: who reads it asks no format.
#include "ui/jobs/plan_file.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/units.h"
#include "ui/jobs/geometry_json.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;
using scenarios::FaceKind;
using scenarios::Plan;
using scenarios::PlannedCut;
using scenarios::PlannedFragment;
using scenarios::PlannedHinge;
using scenarios::PlannedImplant;
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

ordered_json name_or_null(const std::string& name) {
  return name.empty() ? ordered_json(nullptr) : ordered_json(name);
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
          {"along_bone", cut.is_along_bone},
          {"hinge", name_or_null(cut.hinge)},
          {"blade", name_or_null(reference.blade)}};
}

ordered_json hinge_json(const PlannedHinge& hinge, const scenarios::ReferenceHinge& reference) {
  const simulator::HingeLine& line = hinge.bridge.line;
  return {{"name", hinge.name},
          {"first_cut", hinge.first_cut},
          {"second_cut", hinge.second_cut},
          {"point_in_bone_mm", vector_json(line.point_in_bone_mm)},
          {"axis", vector_json(line.axis)},
          {"outward", vector_json(line.outward)},
          {"wedge_deg", degree_from_radian(hinge.wedge_rad)},
          {"thickness_mm", line.thickness_mm},
          {"target_mm", {reference.target_low_mm, hinge.target_high_mm}}};
}

ordered_json zone_json(const scenarios::PlannedZone& zone, const scenarios::DangerZone& reference) {
  return {{"name", zone.name},
          {"severity", reference.severity},
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

ordered_json fragment_json(const PlannedFragment& fragment) {
  return {{"name", fragment.name},
          {"holds_in_bone_mm", vector_json(fragment.holds_in_bone_mm)},
          {"volume_mm3", fragment.volume_mm3},
          {"pose", matrix_json(fragment.bone_from_rest)},
          {"dorsal_in_bone", vector_json(fragment.foot_dorsal_in_bone)}};
}

ordered_json range_json(const scenarios::Range& range) { return {range.low_mm, range.high_mm}; }

ordered_json implant_json(const PlannedImplant& implant) {
  const bool is_screw = implant.kind == scenarios::ImplantKind::Screw;
  return {{"name", implant.name},
          {"kind", is_screw ? "screw" : "wire"},
          {"entry_in_bone_mm", vector_json(implant.entry_in_bone_mm)},
          {"tip_in_bone_mm", vector_json(implant.tip_in_bone_mm)},
          {"direction", vector_json(implant.direction_in_bone)},
          {"lengths_mm", range_json(implant.lengths)},
          {"diameters_mm", range_json(implant.diameters)},
          {"engages", implant.engages},
          {"temporary", implant.is_temporary}};
}

/// They lie first on the tray.
ordered_json blades_json(const Scenario& scenario) {
  ordered_json blades = ordered_json::array();
  for (const scenarios::LaidOutTool& laid_out : scenarios::laid_out_tools(scenario)) {
    const auto* const saw = std::get_if<simulator::Saw>(&laid_out.tool);
    if (saw == nullptr) continue;
    ordered_json blade;
    blade["name"] = laid_out.name;
    blade.update(blade_json(saw->blade));
    blades.push_back(std::move(blade));
  }
  return blades;
}

/// What bores, each with its place on the tray.
ordered_json boring_tools_json(const Scenario& scenario) {
  ordered_json tools = ordered_json::array();
  std::int32_t place = 0;
  for (const scenarios::LaidOutTool& laid_out : scenarios::laid_out_tools(scenario)) {
    if (!std::holds_alternative<simulator::Saw>(laid_out.tool)) {
      tools.push_back({{"place", place},
                       {"name", laid_out.name},
                       {"radius_mm", bored_radius_mm(laid_out.tool)},
                       {"shaft_mm", shaft_length_mm(laid_out.tool)}});
    }
    ++place;
  }
  return tools;
}

/// The lists of a plan. Where a patient has several bones each part says the one in whose frame it
/// is.
class PlanLists {
 public:
  explicit PlanLists(const simulator::Bones& bones) : bones_(bones) {}

  /// Of each the JSON that `json_of` says.
  template <typename Part, typename Of>
  ordered_json of(const std::vector<Part>& parts, Of&& json_of) const {
    ordered_json list = ordered_json::array();
    for (const Part& part : parts) add(list, json_of(part), part.bone);
    return list;
  }
  /// The same of parts, each with that of the scenario that it was planned from.
  template <typename Part, typename Reference, typename Of>
  ordered_json of(const std::vector<Part>& parts, const std::vector<Reference>& references,
                  Of&& json_of) const {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < parts.size(); ++i)
      add(list, json_of(parts[i], references[i]), parts[i].bone);
    return list;
  }

 private:
  void add(ordered_json& list, ordered_json part, std::size_t bone) const {
    if (bones_.size() > 1) part["bone"] = bones_[bone].name;
    list.push_back(std::move(part));
  }

  const simulator::Bones& bones_;
};

ordered_json further_bones_json(const simulator::Bones& bones) {
  ordered_json further = ordered_json::array();
  for (std::size_t bone = 1; bone < bones.size(); ++bone) {
    further.push_back({{"name", bones[bone].name},
                       {"landmarks", landmarks_json(bones[bone])},
                       {"world_from_bone", matrix_json(bones[bone].world_from_bone)}});
  }
  return further;
}

}  // namespace

std::string plan_file(const Scenario& scenario, const simulator::Bones& bones, const Plan& plan) {
  const PlanLists list(bones);
  const simulator::Bone& bone = bones.first();
  ordered_json json{
      {"format", plan_file_format},
      {"scenario", scenario.name},
      {"scenario_version", scenario.version},
      {"bone", bone.name},
      {"landmarks", landmarks_json(bone)},
      {"cuts", list.of(plan.cuts, scenario.cuts, cut_json)},
      {"hinges", list.of(plan.hinges, scenario.hinges, hinge_json)},
      {"danger_zones", list.of(plan.danger_zones, scenario.danger_zones, zone_json)},
      {"joint_surfaces", list.of(plan.joint_surfaces, scenario.joint_surfaces, joint_json)},
      {"fragments", list.of(plan.fixation.fragments, fragment_json)},
      {"implants", list.of(plan.fixation.implants, implant_json)},
      {"world_from_bone", matrix_json(bone.world_from_bone)},
      {"blade", blade_json(scenario.saw.blade)},
      {"blades", blades_json(scenario)},
      {"boring_tools", boring_tools_json(scenario)}};
  if (bones.size() > 1) json["further_bones"] = further_bones_json(bones);
  // The names of a bone from elsewhere may be no UTF-8.
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace hallux::ui
