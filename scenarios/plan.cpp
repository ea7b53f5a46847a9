/// Faces come from landmarks of this bone, so a plan is made in an order: cuts that stand alone,
/// the hinge in the first of them, then the cut through the hinge, and last the zones. Normals
/// point into the waste. Where a plane misses the bone, or the landmarks of an axis coincide, the
/// cut is refused with its path: a patient that the scenario cannot be done on is no patient of it.
#include "scenarios/plan.h"

#include <algorithm>
#include <optional>

#include "scenarios/landmark_of.h"
#include "simulator/base/elementary.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

/// Shorter than this a direction between two landmarks says nothing [mm, or the sine of an angle].
constexpr double direction_length_min = 1.0e-3;

Vec3 unit_or_refuse(const Vec3& direction, const std::string& cut_path, std::string_view what) {
  const double length = length_of(direction);
  if (!(length > direction_length_min)) {
    throw ScenarioError(cut_path + ": " + std::string(what) + "; name other axis landmarks");
  }
  return direction / length;
}

Vec3 direction_of(std::string_view side) {
  if (side == "distal") return {1.0, 0.0, 0.0};
  if (side == "proximal") return {-1.0, 0.0, 0.0};
  if (side == "dorsal") return {0.0, 1.0, 0.0};
  if (side == "plantar") return {0.0, -1.0, 0.0};
  return {0.0, 0.0, side == "lateral" ? 1.0 : -1.0};
}

/// One cut on its way to a plan: what the scenario asks, the bone, and the words that a refusal
/// begins with.
struct Asked {
  const Scenario& scenario;
  const ReferenceCut& cut;
  const Bone& bone;
  std::string path;
};

/// Towards the waste, square to the axis, then turned about the axis. For an axis that points
/// distally (+x) the turn raises the dorsal component of a medial normal, so the plane runs further
/// medial as it goes plantar.
Vec3 normal_along(const Asked& asked, const Vec3& axis) {
  const Vec3 side = direction_of(asked.cut.waste_side);
  const Vec3 square = unit_or_refuse(side - glm::dot(side, axis) * axis, asked.path,
                                     "the axis runs from the kept side to the waste");
  const double tilt_rad = asked.cut.face.frontal_tilt_rad;
  return elementary::cos(tilt_rad) * square + elementary::sin(tilt_rad) * glm::cross(axis, square);
}

void plan_along_axis(const Asked& asked, const Vec3& axis, PlannedCut& planned) {
  const ReferenceCut& cut = asked.cut;
  // The axis says distal whichever way round the file names its ends; the tilt is counted about it.
  planned.axis = axis.x < 0.0 ? -axis : axis;
  planned.face.normal = normal_along(asked, planned.axis);
  planned.face.offset_mm =
      glm::dot(planned.face.normal, landmark_of(asked.bone, cut.face.through, asked.path)) +
      cut.face.offset_mm;
  planned.depth_point_in_bone_mm = landmark_of(asked.bone, cut.depth_landmark, asked.path);
  planned.exit_point_in_bone_mm = landmark_of(asked.bone, cut.exit_landmark, asked.path);
  planned.depth_mm =
      planned.face.offset_mm - glm::dot(planned.face.normal, planned.depth_point_in_bone_mm);
}

/// Dorsal, as far as it lies in the face with this normal.
Vec3 dorsal_in(const Vec3& normal, const std::string& path) {
  const Vec3 dorsal = direction_of("dorsal");
  return unit_or_refuse(dorsal - glm::dot(dorsal, normal) * normal, path,
                        "its face lies level with the sole");
}

double tangent(double angle_rad) { return elementary::sin(angle_rad) / elementary::cos(angle_rad); }

void plan_transverse(const Asked& asked, const Vec3& axis, PlannedCut& planned) {
  const LandmarkPlane& face = asked.cut.face;
  const Vec3 dorsal = direction_of("dorsal");
  const Vec3 lateral = axis.z < 0.0 ? -axis : axis;
  const Vec3 distal = unit_or_refuse(glm::cross(dorsal, lateral), asked.path,
                                     "the line between its axis landmarks runs dorsally");
  const Vec3 tilted =
      glm::normalize(distal + tangent(face.sagittal_tilt_rad) * dorsal +
                     tangent(face.transverse_tilt_rad) * glm::cross(distal, dorsal));
  planned.face.normal = asked.cut.waste_side == "distal" ? tilted : -tilted;
  planned.face.offset_mm =
      glm::dot(planned.face.normal,
               landmark_of(asked.bone, face.through, asked.path) + Vec3{face.offset_mm, 0.0, 0.0});
  planned.axis = dorsal_in(tilted, asked.path);
}

void plan_through_hinge(const Asked& asked, const Plan& plan, PlannedCut& planned) {
  const PlannedHinge& hinge = *find_hinge(plan, asked.cut.face.through);
  const simulator::HingeLine& line = hinge.bridge.line;
  const Vec3 first = glm::cross(line.axis, line.outward);
  const Vec3 distal = first.x < 0.0 ? -first : first;
  const Vec3 turned =
      elementary::cos(hinge.wedge_rad) * distal + elementary::sin(hinge.wedge_rad) * line.outward;
  planned.face.normal = asked.cut.waste_side == "distal" ? turned : -turned;
  planned.face.offset_mm = glm::dot(planned.face.normal, line.point_in_bone_mm);
  planned.axis = line.axis;
}

/// The point of the bone's section by the face that lies furthest in the direction; nothing where
/// the face misses.
std::optional<Vec3> furthest_in_face(const ReferenceFace& face, const simulator::IndexedMesh& mesh,
                                     const Vec3& direction) {
  std::optional<Vec3> furthest;
  for (const simulator::Triangle& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3& from = mesh.points_mm[triangle[corner]];
      const Vec3& to = mesh.points_mm[triangle[(corner + 1) % 3]];
      const double from_mm = glm::dot(face.normal, from) - face.offset_mm;
      const double to_mm = glm::dot(face.normal, to) - face.offset_mm;
      if ((from_mm > 0.0) == (to_mm > 0.0)) continue;
      const Vec3 point = from + from_mm / (from_mm - to_mm) * (to - from);
      if (!furthest || glm::dot(direction, point) > glm::dot(direction, *furthest)) {
        furthest = point;
      }
    }
  }
  return furthest;
}

PlannedCut plan_cut(const Asked& asked, const Plan& plan) {
  const LandmarkPlane& face = asked.cut.face;
  PlannedCut planned;
  planned.name = asked.cut.name;
  planned.kind = face.kind;
  if (face.kind == FaceKind::ThroughHinge) {
    plan_through_hinge(asked, plan, planned);
  } else {
    const Vec3 axis = unit_or_refuse(landmark_of(asked.bone, face.axis_to, asked.path) -
                                         landmark_of(asked.bone, face.axis_from, asked.path),
                                     asked.path, "the landmarks of its axis coincide");
    if (face.kind == FaceKind::AlongAxis) plan_along_axis(asked, axis, planned);
    if (face.kind == FaceKind::Transverse) plan_transverse(asked, axis, planned);
  }
  const std::optional<Vec3> entry =
      furthest_in_face(planned.face, asked.bone.outer, direction_of(asked.cut.approach));
  if (!entry) {
    throw ScenarioError(asked.path + ": its plane misses the bone \"" + asked.bone.name +
                        "\"; mend face.offset_mm or face.through");
  }
  planned.entry_point_in_bone_mm = *entry;
  if (face.kind != FaceKind::AlongAxis) planned.depth_point_in_bone_mm = *entry;
  return planned;
}

/// A line that stays planned_mm inside the bone's furthest point of the face.
PlannedHinge plan_hinge(const Scenario& scenario, const ReferenceHinge& hinge, const Plan& plan,
                        const Bone& bone, const std::string& path) {
  const PlannedCut& first = *find_cut(plan, hinge.first_cut);
  const Vec3 across = glm::cross(first.face.normal, first.axis);
  const Vec3 outward = glm::dot(across, direction_of(hinge.side)) < 0.0 ? -across : across;
  const Vec3 far = furthest_in_face(first.face, bone.outer, outward).value();
  const Vec3 point_mm = far - hinge.thickness_mm * outward;
  PlannedHinge planned{hinge.name,
                       hinge.first_cut,
                       hinge.second_cut,
                       {.line = {point_mm, first.axis, outward, hinge.thickness_mm},
                        .breaks_below_mm = hinge.breaks_below_mm,
                        .bends_up_to_mm = hinge.bends_up_to_mm},
                       0.0,
                       hinge.target_high_mm};
  if (glm::dot(outward, point_mm - first.entry_point_in_bone_mm) <= hinge.thickness_mm) {
    throw ScenarioError(path + ": the bone \"" + bone.name +
                        "\" is too thin for it; mend thickness_mm or the face of \"" +
                        hinge.first_cut + "\"");
  }
  for (const ReferenceCut& cut : scenario.cuts) {
    if (cut.name == hinge.second_cut) planned.wedge_rad = cut.face.wedge_rad;
  }
  return planned;
}

std::string path_of(const Scenario& scenario, std::string_view list, std::size_t index,
                    const std::string& name) {
  return scenario.name + ": " + std::string(list) + "[" + std::to_string(index) + "] \"" + name +
         "\"";
}

/// Cuts of these kinds, in the order of the file.
void plan_cuts(const Scenario& scenario, const Bone& bone, bool is_through_hinge, Plan& plan) {
  for (std::size_t i = 0; i < scenario.cuts.size(); ++i) {
    const ReferenceCut& cut = scenario.cuts[i];
    if ((cut.face.kind == FaceKind::ThroughHinge) != is_through_hinge) continue;
    plan.cuts[i] = plan_cut({scenario, cut, bone, path_of(scenario, "cuts", i, cut.name)}, plan);
  }
}

template <typename Part>
const Part* find_named(const std::vector<Part>& parts, std::string_view name) noexcept {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

}  // namespace

const PlannedCut* find_cut(const Plan& plan, std::string_view name) noexcept {
  return find_named(plan.cuts, name);
}

std::size_t index_of_cut(const Plan& plan, std::string_view name) noexcept {
  return static_cast<std::size_t>(find_cut(plan, name) - plan.cuts.data());
}

const PlannedHinge* find_hinge(const Plan& plan, std::string_view name) noexcept {
  return find_named(plan.hinges, name);
}

simulator::PlannedBridges planned_bridges(const Plan& plan) {
  simulator::PlannedBridges bridges;
  for (const PlannedHinge& hinge : plan.hinges) bridges.push_back(hinge.bridge);
  return bridges;
}

Plan plan_on(const Scenario& scenario, const Bone& bone) {
  Plan plan;
  plan.cuts.resize(scenario.cuts.size());
  // A hinge lies in one face and carries another.
  plan_cuts(scenario, bone, false, plan);
  for (std::size_t i = 0; i < scenario.hinges.size(); ++i) {
    const ReferenceHinge& hinge = scenario.hinges[i];
    plan.hinges.push_back(
        plan_hinge(scenario, hinge, plan, bone, path_of(scenario, "hinges", i, hinge.name)));
  }
  plan_cuts(scenario, bone, true, plan);
  for (const PlannedHinge& hinge : plan.hinges) {
    for (PlannedCut& cut : plan.cuts) {
      if (cut.name != hinge.first_cut && cut.name != hinge.second_cut) continue;
      cut.hinge = hinge.name;
      cut.exit_point_in_bone_mm = hinge.bridge.line.point_in_bone_mm;
    }
  }
  plan.danger_zones = plan_zones(scenario, bone);
  plan.joint_surfaces = plan_joint_surfaces(scenario, bone);
  return plan;
}

}  // namespace hallux::scenarios
