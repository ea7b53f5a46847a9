#include "ui/sight/start_place.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hallux::ui {

namespace {

constexpr double stand_off_mm = 30.0;
/// What one wants to see around the site: most of a phalanx, the head and half the shaft of a
/// metatarsal.
constexpr double usual_aspect = 1.6;
constexpr double site_share_of_bone = 0.5, site_least_mm = 20.0, site_most_mm = 30.0;

/// Bone frame: y dorsal, z lateral.
Vec3 feed_of(std::string_view approach) {
  if (approach == "dorsal") return {0.0, -1.0, 0.0};
  if (approach == "plantar") return {0.0, 1.0, 0.0};
  return approach == "lateral" ? Vec3(0.0, 0.0, -1.0) : Vec3(0.0, 0.0, 1.0);
}

/// The axis of the bone, square to the feed, that a planned normal lies nearest to.
Vec3 nearest_axis(const Vec3& normal, const Vec3& feed) {
  Vec3 best(1.0, 0.0, 0.0);
  double most = -1.0;
  for (const Vec3& axis :
       std::array{Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)}) {
    const double along = std::abs(glm::dot(axis, normal));
    if (std::abs(glm::dot(axis, feed)) > 0.5 || along <= most) continue;
    most = along;
    best = glm::dot(axis, normal) < 0.0 ? -axis : axis;
  }
  return best;
}

const scenarios::PlannedCut& first_cut(const scenarios::Scenario& scenario,
                                       const scenarios::Plan& plan) {
  for (const scenarios::OperationStep& step : scenario.steps) {
    const scenarios::PlannedCut* cut = find_cut(plan, step.cut);
    if (step.kind == scenarios::StepKind::Cut && cut != nullptr) return *cut;
  }
  return plan.cuts.front();
}

Quat facing(const Vec3& eye_in_world, const Vec3& up_in_world) {
  const Vec3 right = unit(glm::cross(up_in_world, eye_in_world));
  return rotation_from_axes(right, glm::cross(eye_in_world, right));
}

Vec3 site_in_bone_mm(const scenarios::PlannedCut& cut) {
  return 0.5 * (cut.entry_point_in_bone_mm + cut.exit_point_in_bone_mm);
}

}  // namespace

RigidTransform start_pose(const scenarios::Scenario& scenario, simulator::Bones bones,
                          const scenarios::Plan& plan) {
  const scenarios::PlannedCut& cut = first_cut(scenario, plan);
  const simulator::Bone& bone = bones[cut.bone];
  if (const auto& start = scenario.start) {
    const Vec3 across = glm::cross(start->normal_in_bone, start->feed_in_bone);
    return bone.world_from_bone *
           RigidTransform{rotation_from_axes(start->feed_in_bone, across),
                          cut.entry_point_in_bone_mm + start->tip_from_entry_mm};
  }
  const auto reference = std::ranges::find_if(
      scenario.cuts, [&](const scenarios::ReferenceCut& each) { return each.name == cut.name; });
  const Vec3 feed = feed_of(reference->approach);
  const Vec3 normal = nearest_axis(cut.face.normal, feed);
  const RigidTransform bone_from_tool{rotation_from_axes(feed, glm::cross(normal, feed)),
                                      cut.entry_point_in_bone_mm - stand_off_mm * feed};
  return bone.world_from_bone * bone_from_tool;
}

Camera start_camera(const scenarios::Scenario& scenario, simulator::Bones bones,
                    const scenarios::Plan& plan) {
  const scenarios::PlannedCut& cut = first_cut(scenario, plan);
  const simulator::Bone& bone = bones[cut.bone];
  Camera camera;
  camera.target_mm = transform_point(bone.world_from_bone, site_in_bone_mm(cut));
  if (const auto& start = scenario.start) {
    camera = fitted(camera, Viewer{}, start->radius_mm, usual_aspect);
    camera.world_from_view = facing(transform_direction(bone.world_from_bone, start->eye_in_bone),
                                    transform_direction(bone.world_from_bone, start->up_in_bone));
    return camera;
  }
  const double length_mm =
      cut.bone == 0 ? scenario.patient.length_mm : scenario.further_bones[cut.bone - 1].length_mm;
  const double radius_mm = std::clamp(site_share_of_bone * length_mm, site_least_mm, site_most_mm);
  return standard_view(fitted(camera, Viewer{}, radius_mm, usual_aspect), StandardView::Operator);
}

}  // namespace hallux::ui
