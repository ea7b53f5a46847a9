#include "tests/scenarios/site/block_site.h"

#include <utility>

#include "scenarios/site/planned_passes.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/support/worlds.h"

namespace hallux::tests {

using namespace scenarios;
using namespace simulator;

Bone site_block() {
  Bone bone;
  bone.name = "stand_in";
  bone.outer = moved(solid_block({33.0, 13.0, 15.0}), {{}, {16.5, 0.0, 0.0}});
  bone.landmarks = {{"base_centre", Vec3(0.0, 0.0, 0.0)},   {"base_med", Vec3(0.0, 0.0, -7.5)},
                    {"base_lat", Vec3(0.0, 0.0, 7.5)},      {"shaft_proximal", Vec3(0.0, 0.0, 0.0)},
                    {"shaft_distal", Vec3(33.0, 0.0, 0.0)}, {"med_sulcus", Vec3(16.5, 6.5, -3.0)},
                    {"shaft_medial", Vec3(16.5, 0.0, -4.0)}};
  return bone;
}

Scenario along_scenario(double blade_width_mm) {
  Scenario scenario = scenarios_test::format_1("silver");
  scenario.cuts[0].face.frontal_tilt_rad = 0.0;
  scenario.saw.blade.width_mm = blade_width_mm;
  scenario.danger_zones.clear();
  scenario.joint_surfaces.clear();
  return scenario;
}

Scenario wedge_scenario(double blade_width_mm) {
  Scenario scenario = scenarios_test::format_1("akin");
  scenario.saw.blade.width_mm = blade_width_mm;
  scenario.danger_zones.clear();
  scenario.joint_surfaces.clear();
  return scenario;
}

BlockSite::BlockSite(Scenario asked)
    : scenario(std::move(asked)),
      bone(site_block()),
      plan(plan_on(scenario, bone)),
      whole(uncut_solid(solid_of(bone))),
      bvh(whole.mesh),
      kerfs(scenario.saw.blade, bone.world_from_bone) {}

RigidTransform BlockSite::bone_from_blade(std::size_t cut, double along_mm, double depth_mm) const {
  const PlannedPasses passes = planned_passes(scenario, plan, cut, whole, bvh);
  const Vec3 middle_mm = plan.cuts[cut].entry_point_in_bone_mm +
                         0.5 * scenario.saw.blade.kerf_mm * plan.cuts[cut].face.normal;
  return {rotation_from_axes(passes.feed_in_bone, passes.along_in_bone),
          middle_mm + (0.5 * (passes.low_mm + passes.high_mm) + along_mm) * passes.along_in_bone +
              depth_mm * passes.feed_in_bone};
}

CutEvent BlockSite::freeze(std::size_t cut, double shifted_mm) {
  RigidTransform pose = bone_from_blade(cut, 0.0, -1.0);
  pose.translation_mm += shifted_mm * plan.cuts[cut].face.normal;
  CutEvent frozen;
  frozen.tick = tick_++;
  frozen.kind = CutEventKind::PlaneFrozen;
  frozen.pose = quantise(pose);
  frozen.subject = kerfs.freeze(frozen.pose);
  cut_of_kerf_.push_back(cut);
  shift_of_kerf_.push_back(shifted_mm);
  return frozen;
}

void BlockSite::saw(std::int32_t kerf, double along_mm, double depth_mm) {
  const auto index = static_cast<std::size_t>(kerf);
  ToolSample sample;
  sample.kerf = kerf;
  sample.status = bit(ToolStatus::SawOn);
  for (const double at_mm : {-1.0, depth_mm}) {
    RigidTransform pose = bone_from_blade(cut_of_kerf_[index], along_mm, at_mm);
    pose.translation_mm += shift_of_kerf_[index] * plan.cuts[cut_of_kerf_[index]].face.normal;
    sample.tick = tick_++;
    sample.world_from_tool = quantise(bone.world_from_bone * pose);
    kerfs.apply(sample);
  }
  sample.kerf = -1;
  kerfs.apply(sample);
}

}  // namespace hallux::tests
