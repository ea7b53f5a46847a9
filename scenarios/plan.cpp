#include "scenarios/plan.h"

#include <cmath>

#include "scenarios/foot/first_metatarsal.h"
#include "simulator/base/elementary.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

/// Shorter than this a direction between two landmarks says nothing [mm, or the sine of an angle].
constexpr double direction_length_min = 1.0e-3;

Vec3 landmark_of(const Bone& bone, const std::string& name, const std::string& cut_path) {
  if (const std::optional<Vec3> point = simulator::find_landmark(bone, name)) return *point;
  std::string known;
  for (const simulator::Landmark& landmark : bone.landmarks) {
    known += (known.empty() ? "" : ", ") + landmark.name;
  }
  throw ScenarioError(cut_path + ": the bone \"" + bone.name + "\" has no landmark \"" + name +
                      "\"; use one of: " + known);
}

Vec3 unit_or_refuse(const Vec3& direction, const std::string& cut_path, std::string_view what) {
  const double length = std::sqrt(glm::dot(direction, direction));
  if (!(length > direction_length_min)) {
    throw ScenarioError(cut_path + ": " + std::string(what) + "; name other axis landmarks");
  }
  return direction / length;
}

/// Towards the waste, square to the axis, then turned about the axis. For an axis that points distally (+x) the turn
/// raises the dorsal component of a medial normal, so the plane runs further medial as it goes plantar.
Vec3 face_normal(const ReferenceCut& cut, const Vec3& axis, const std::string& cut_path) {
  const Vec3 side(0.0, 0.0, cut.waste_side == "lateral" ? 1.0 : -1.0);
  const Vec3 square = unit_or_refuse(side - glm::dot(side, axis) * axis, cut_path,
                                     "the axis runs from the kept side to the waste");
  const double tilt_rad = cut.face.frontal_tilt_rad;
  return elementary::cos(tilt_rad) * square + elementary::sin(tilt_rad) * glm::cross(axis, square);
}

bool crosses(const ReferenceFace& face, const simulator::IndexedMesh& mesh) {
  for (const simulator::Triangle& triangle : mesh.triangles) {
    int above = 0;
    for (const std::uint32_t point : triangle) {
      above += glm::dot(face.normal, mesh.points_mm[point]) > face.offset_mm ? 1 : 0;
    }
    if (above == 1 || above == 2) return true;
  }
  return false;
}

PlannedCut plan_cut(const ReferenceCut& cut, const Bone& bone, const std::string& cut_path) {
  const Vec3 from = landmark_of(bone, cut.face.axis_from, cut_path);
  const Vec3 to = landmark_of(bone, cut.face.axis_to, cut_path);
  const Vec3 through = landmark_of(bone, cut.face.through, cut_path);
  PlannedCut planned;
  planned.name = cut.name;
  planned.axis = unit_or_refuse(to - from, cut_path, "the landmarks of its axis coincide");
  // The axis says distal whichever way round the file names its ends; the tilt is counted about it.
  if (planned.axis.x < 0.0) planned.axis = -planned.axis;
  planned.face.normal = face_normal(cut, planned.axis, cut_path);
  planned.face.offset_mm = glm::dot(planned.face.normal, through) + cut.face.offset_mm;
  planned.depth_point_in_bone_mm = landmark_of(bone, cut.depth_landmark, cut_path);
  planned.exit_point_in_bone_mm = landmark_of(bone, cut.exit_landmark, cut_path);
  planned.depth_mm =
      planned.face.offset_mm - glm::dot(planned.face.normal, planned.depth_point_in_bone_mm);
  if (!crosses(planned.face, bone.outer)) {
    throw ScenarioError(cut_path + ": its plane misses the bone \"" + bone.name +
                        "\"; mend face.offset_mm or face.through");
  }
  return planned;
}

}  // namespace

Plan plan_on(const Scenario& scenario, const Bone& bone) {
  Plan plan;
  plan.cuts.reserve(scenario.cuts.size());
  for (std::size_t i = 0; i < scenario.cuts.size(); ++i) {
    const ReferenceCut& cut = scenario.cuts[i];
    const std::string cut_path =
        scenario.name + ": cuts[" + std::to_string(i) + "] \"" + cut.name + "\"";
    plan.cuts.push_back(plan_cut(cut, bone, cut_path));
  }
  return plan;
}

Bone make_patient(const Scenario& scenario, const std::function<bool(double)>& progress) {
  const PatientRequest& patient = scenario.patient;
  if (patient.bone != "first_metatarsal") {
    throw ScenarioError(scenario.name + ": patient.bone: there is no bone \"" + patient.bone +
                        "\"; use first_metatarsal");
  }
  return make_first_metatarsal(first_metatarsal_table(),
                               {.length_mm = patient.length_mm,
                                .eminence_mm = patient.eminence_mm,
                                .edge_mm = patient.edge_mm},
                               progress);
}

}  // namespace hallux::scenarios
