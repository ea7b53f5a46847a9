// A patient before the operation, for cards, briefing and sign-in: the same bones and planned
// faces, framed differently.
#include "ui/screens/pictures/patient_view.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include "scenarios/neighbour.h"
#include "simulator/base/digest.h"
#include "simulator/base/progress.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"
#include "ui/screens/pictures/planned_frame.h"

namespace hallux::ui {

namespace {

using scenarios::PlannedCut;

constexpr double pair_share = 0.97;  // two bones in a row leave most of their ball empty
constexpr double saw_gap_mm = 5.0;   // the blade waits before the bone

/// One for each content: the renderer knows bones by it.
std::uint64_t id_of(const scenarios::Scenario& scenario, std::string_view part, double edge_mm) {
  Digester digester;
  digester.add_text(scenario.text);
  digester.add_text(part);
  digester.add_double(edge_mm);
  const Digest digest = digester.finish();
  std::uint64_t id = 0;
  std::memcpy(&id, digest.bytes.data(), sizeof id);
  return id | 1U;
}

BoneInView bone_in_view(std::uint64_t id, const simulator::Bone& bone) {
  BoneInView shown;
  shown.look = look_of(id, bone);
  shown.mesh = mesh_of(id, simulator::uncut_solid(solid_of(bone)), shown.look);
  shown.world_from_bone = bone.world_from_bone;
  return shown;
}

/// The frame of the face: x where the blade goes, z its normal.
RigidTransform bone_from_face(const PlannedCut& cut) {
  const Vec3 normal = cut.face.normal, from = cut.approach_in_bone;
  const Vec3 feed = glm::normalize(glm::dot(from, normal) * normal - from);
  return {rotation_from_axes(feed, glm::cross(normal, feed)), cut.face.offset_mm * normal};
}

FaceInView face_in_view(const BoneInView& bone, const simulator::Bvh& tree, const PlannedCut& cut) {
  const PlannedFace face =
      planned_face(bone.mesh.solid, tree, bone_from_face(cut), cut.depth_point_in_bone_mm);
  return {bone.world_from_bone * face.bone_from_face, face.half_mm, Vec2(face.entry_x_mm, 0.0)};
}

SawInScene saw_of(const PatientView& view) {
  const FaceInView& face = view.faces.front();
  SawInScene saw;
  saw.world_from_tool =
      face.world_from_plane *
      RigidTransform{Quat(1.0, 0.0, 0.0, 0.0), Vec3(face.entry_mm.x - saw_gap_mm, 0.0, 0.0)};
  saw.blade = view.blade;
  return saw;
}

const BoneInView& operated(const PatientView& view, std::size_t bone) {
  return bone == 0 ? view.bone : view.further[bone - 1];
}

/// Each on its bone.
void add_cuts(PatientView& view, const scenarios::Scenario& scenario, const scenarios::Plan& plan) {
  std::vector<std::unique_ptr<const simulator::Bvh>> trees;
  for (std::size_t bone = 0; bone <= view.further.size(); ++bone)
    trees.push_back(std::make_unique<const simulator::Bvh>(operated(view, bone).mesh.solid.mesh));
  for (std::size_t index = 0; index < plan.cuts.size(); ++index) {
    const PlannedCut& cut = plan.cuts[index];
    const BoneInView& bone = operated(view, cut.bone);
    view.faces.push_back(face_in_view(bone, *trees[cut.bone], cut));
    view.passes.push_back(passes_in_view(scenario, plan, index, bone.mesh.solid, *trees[cut.bone]));
  }
}

}  // namespace

PatientView make_patient_view(const scenarios::Scenario& scenario, const Progress& progress,
                              double edge_mm) {
  scenarios::Scenario coarse = scenario;
  coarse.patient.edge_mm = std::max(coarse.patient.edge_mm, edge_mm);
  for (scenarios::PatientRequest& further : coarse.further_bones)
    further.edge_mm = std::max(further.edge_mm, edge_mm);
  const std::vector<simulator::Bone> bones = make_patient_bones(coarse, progress);
  const scenarios::Plan plan = plan_on(coarse, bones);
  PatientView view;
  view.scenario_name = scenario.name;
  view.bone = bone_in_view(id_of(scenario, "bone", coarse.patient.edge_mm), bones.front());
  for (std::size_t i = 1; i < bones.size(); ++i) {
    const double further_mm = coarse.further_bones[i - 1].edge_mm;
    view.further.push_back(bone_in_view(id_of(scenario, bones[i].name, further_mm), bones[i]));
  }
  const double neighbour_mm = std::max(scenarios::neighbour_edge_mm, edge_mm);
  if (const auto neighbour = scenarios::neighbour_of(scenario, neighbour_mm))
    view.neighbour = bone_in_view(id_of(scenario, "neighbour", neighbour_mm), *neighbour);
  add_cuts(view, coarse, plan);
  view.blade = scenario.saw.blade;
  return view;
}

namespace {

/// A ball around a bone.
struct Ball {
  Vec3 middle_in_world_mm{0.0, 0.0, 0.0};
  double radius_mm = 0.0;
};

Ball ball_around(const BoneInView& bone) {
  const Vec3 half_mm = 0.5 * (bone.mesh.high_mm - bone.mesh.low_mm);
  return {transform_point(bone.world_from_bone, bone.mesh.low_mm + half_mm), glm::length(half_mm)};
}

Ball ball_around(const Ball& a, const Ball& b) {
  const Vec3 way = b.middle_in_world_mm - a.middle_in_world_mm;
  const double radius_mm = 0.5 * (glm::length(way) + a.radius_mm + b.radius_mm);
  return {a.middle_in_world_mm + (radius_mm - a.radius_mm) * glm::normalize(way), radius_mm};
}

/// What the picture is about.
Ball shown_in(const PatientView& view, PatientPicture picture) {
  Ball shown = ball_around(view.bone);
  for (const BoneInView& further : view.further) shown = ball_around(shown, ball_around(further));
  if (picture == PatientPicture::Pair && view.neighbour)
    return ball_around(shown, ball_around(*view.neighbour));
  if (picture == PatientPicture::Whole || view.faces.empty()) return shown;
  const FaceInView& face = view.faces.front();
  shown.middle_in_world_mm =
      0.45 * shown.middle_in_world_mm + 0.55 * face.world_from_plane.translation_mm;
  shown.radius_mm = std::max(0.62 * shown.radius_mm, 1.1 * glm::length(face.half_mm));
  return shown;
}

}  // namespace

Scene scene_of(const PatientView& view, PatientPicture picture, Ground ground) {
  Scene scene;
  scene.ground = ground;
  const auto add = [&](const BoneInView& bone, double presence) {
    BoneInScene& shown = scene.bones.emplace_back();
    shown.mesh = &bone.mesh;
    shown.look = &bone.look;
    shown.world_from_bone = bone.world_from_bone;
    shown.presence = presence;
  };
  add(view.bone, 1.0);
  for (const BoneInView& further : view.further) add(further, 1.0);
  if (view.neighbour)
    add(*view.neighbour, picture == PatientPicture::Pair ? 1.0 : neighbour_presence);
  for (const FaceInView& face : view.faces) {
    if (scene.planes.size() == lines_at_most) break;
    scene.planes.push_back({face.world_from_plane, face.half_mm});
  }
  if (picture == PatientPicture::Card && !view.faces.empty()) scene.saw = saw_of(view);
  return scene;
}

double radius_of(const PatientView& view, PatientPicture picture) {
  const double radius_mm = shown_in(view, picture).radius_mm;
  return picture == PatientPicture::Pair ? pair_share * radius_mm : radius_mm;
}

Camera camera_of(const PatientView& view, PatientPicture picture, double width_over_height) {
  Camera camera;
  camera.target_mm = shown_in(view, picture).middle_in_world_mm;
  camera = orbited(standard_view(camera, StandardView::Medial), 0.35, 0.42);
  return fitted(camera, Viewer{}, radius_of(view, picture), width_over_height);
}

}  // namespace hallux::ui
