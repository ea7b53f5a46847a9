// A hand aims at the cuts of a scenario of format 2 as at any other.
#include <gtest/gtest.h>

#include "scenarios/hands/hand_aim.h"
#include "scenarios/hands/hand_skill.h"
#include "scenarios/patient.h"

namespace hallux::scenarios {
namespace {

TEST(Format2Aim, WithoutErrorIsThePlan) {
  for (const char* name : {"akin", "chevron", "silver"}) {
    Scenario scenario = load_shipped_scenario(name);
    scenario.patient.edge_mm = 1.0;
    const simulator::Bone bone = make_patient_bones(scenario).front();
    const Plan plan = plan_on(scenario, bone);
    const KnownBones known(bone);
    const std::vector<AimedCut> aims = aim(scenario, plan, known, hand_skill("perfect"), 1);
    ASSERT_EQ(aims.size(), plan.cuts.size());
    for (std::size_t i = 0; i < aims.size(); ++i) {
      const ReferenceFace& face = plan.cuts[i].face;
      EXPECT_LT(length_of(aims[i].face.normal - face.normal), 1.0e-12) << plan.cuts[i].name;
      EXPECT_NEAR(aims[i].face.offset_mm, face.offset_mm, 1.0e-9) << plan.cuts[i].name;
      // The blade comes from the approach, along the face.
      const Vec3 feed = axis_x(aims[i].plane.bone_from_kerf);
      EXPECT_LT(glm::dot(feed, plan.cuts[i].approach_in_bone), -0.7) << plan.cuts[i].name;
      EXPECT_NEAR(glm::dot(feed, face.normal), 0.0, 1.0e-12) << plan.cuts[i].name;
    }
  }
}

}  // namespace
}  // namespace hallux::scenarios
