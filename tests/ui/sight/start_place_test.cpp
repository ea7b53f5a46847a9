#include "ui/sight/start_place.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

/// A coarse patient, with a start that says what a test wants.
class Placed : public testing::Test {
 protected:
  scenarios::Scenario scenario_ = [] {
    scenarios::Scenario scenario = scenarios::load_shipped_scenario("silver");
    scenario.patient.edge_mm = 1.0;
    return scenario;
  }();
  simulator::Bone bone_ = make_patient_bones(scenario_).front();
  scenarios::Plan plan_ = plan_on(scenario_, bone_);

  Vec3 seen(const Vec3& eye_in_bone, const Vec3& up_in_bone, const Vec3& axis_in_view) {
    scenario_.start->eye_in_bone = eye_in_bone;
    scenario_.start->up_in_bone = up_in_bone;
    const Quat bone_from_world = glm::inverse(bone_.world_from_bone.rotation);
    return bone_from_world * (start_camera(scenario_, bone_, plan_).world_from_view * axis_in_view);
  }
};

TEST_F(Placed, TheEyeStandsWhereTheScenarioSays) {
  const Vec3 to_viewer(0.0, 0.0, 1.0), up(0.0, 1.0, 0.0);
  const Vec3 medial(0.0, 0.0, -1.0), dorsal(0.0, 1.0, 0.0), distal(1.0, 0.0, 0.0);
  EXPECT_LT(seen(medial, dorsal, to_viewer).z, -0.999);
  EXPECT_GT(seen(medial, dorsal, up).y, 0.999);
  EXPECT_GT(seen(medial, -dorsal, to_viewer * -1.0).z, 0.999)
      << "a turned head sees from there too";
  EXPECT_LT(seen(medial, -dorsal, up).y, -0.999);
  EXPECT_GT(seen(dorsal, distal, up).x, 0.999);
}

TEST_F(Placed, TheSawIsHeldWhereTheScenarioSays) {
  scenario_.start->tip_from_entry_mm = Vec3(1.0, 20.0, 3.0);
  const RigidTransform bone_from_tool =
      inverse(bone_.world_from_bone) * start_pose(scenario_, bone_, plan_);
  const Vec3 tip_mm = plan_.cuts.front().entry_point_in_bone_mm + Vec3(1.0, 20.0, 3.0);
  EXPECT_NEAR(glm::distance(bone_from_tool.translation_mm, tip_mm), 0.0, 1.0e-9);
  EXPECT_LT((bone_from_tool.rotation * Vec3(1.0, 0.0, 0.0)).y, -0.999);
}

TEST_F(Placed, ASawWithoutAStartStandsOffTheBoneOnTheSideOfTheApproach) {
  scenario_.start.reset();
  const RigidTransform bone_from_tool =
      inverse(bone_.world_from_bone) * start_pose(scenario_, bone_, plan_);
  EXPECT_GT(bone_from_tool.translation_mm.y, plan_.cuts.front().entry_point_in_bone_mm.y + 20.0);
}

}  // namespace
}  // namespace hallux::ui
