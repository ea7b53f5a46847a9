// Draws the start view of a scenario into a file, for eyes: show_start_view SCENARIO_FILE PICTURE.
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <vector>

#include "scenarios/neighbour.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/picture.h"
#include "ui/sight/start_place.h"
#include "ui/sight/view_judge.h"

namespace {

using namespace hallux;
using namespace hallux::ui;

struct DrawnBone {
  BoneLook look;
  BoneMesh mesh;
  RigidTransform world_from_bone;

  DrawnBone(std::uint64_t id, const simulator::Bone& bone)
      : look(look_of(id, bone)),
        mesh(mesh_of(id, simulator::uncut_solid(solid_of(bone)), look)),
        world_from_bone(bone.world_from_bone) {}
  BoneInScene in_scene(double presence) const {
    BoneInScene bone;
    bone.mesh = &mesh;
    bone.look = &look;
    bone.world_from_bone = world_from_bone;
    bone.presence = presence;
    return bone;
  }
};

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::fprintf(stderr, "usage: show_start_view SCENARIO_FILE PICTURE\n");
    return 2;
  }
  scenarios::Scenario scenario = scenarios::read_scenario(words[1]);
  scenario.patient.edge_mm = 0.6;
  const std::vector<simulator::Bone> bones = make_patient_bones(scenario);
  const scenarios::Plan plan = plan_on(scenario, bones);
  const HeadlessContext context;
  ViewJudge judge(scenario, bones, plan);
  std::deque<DrawnBone> drawn;
  Scene scene;
  for (const simulator::Bone& bone : bones)
    scene.bones.push_back(drawn.emplace_back(11 + drawn.size(), bone).in_scene(1.0));
  if (const auto neighbour = scenarios::neighbour_of(scenario))
    scene.bones.push_back(drawn.emplace_back(11 + drawn.size(), *neighbour).in_scene(0.45));
  const RigidTransform start = start_pose(scenario, bones, plan);
  SawInScene saw;
  saw.world_from_tool = start;
  saw.blade = scenario.saw.blade;
  scene.saw = saw;
  scene.lines = {{.world_from_plane = start, .half_mm = Vec2(0.0, 7.0), .faint_mm = 8.0}};
  Renderer renderer;
  const Camera camera = start_camera(scenario, bones, plan);
  write_png(words[2], render_picture(renderer, scene, camera, {1280, 800}));
  const ViewJudgement judgement = judge.judge(camera, start);
  std::printf("plane %.1f deg, saw %s, %s a lower corner, teeth %.3f, kerf %.3f\n",
              degree_from_radian(judgement.blade_angle_rad),
              judgement.is_saw_inside ? "inside" : "not inside",
              judgement.is_from_lower_corner ? "from" : "not from", judgement.mean.tooth_line_share,
              judgement.mean.kerf_share);
  return 0;
}
