// The Silver of format 1 said in format 2: the same plane.
#include <gtest/gtest.h>

#include "scenarios/patient.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/format_2/fixtures.h"

namespace hallux::scenarios {
namespace {

TEST(ShippedSilver, HasThePlaneOfFormat1) {
  Scenario silver = scenarios_test::format_1("silver");
  silver.patient.edge_mm = 1.0;
  const simulator::Bone bone = make_patient_bones(silver).front();
  const PlannedCut old = plan_on(silver, bone).cuts[0];
  const PlannedCut cut = plan_on(scenarios_test::fixture("silver"), bone).cuts[0];
  constexpr double rounding = 1.0e-11;
  EXPECT_EQ(cut.name, old.name);
  EXPECT_LT(length_of(cut.face.normal - old.face.normal), rounding);
  EXPECT_NEAR(cut.face.offset_mm, old.face.offset_mm, rounding);
  EXPECT_LT(length_of(cut.depth_point_in_bone_mm - old.depth_point_in_bone_mm), rounding);
  EXPECT_TRUE(cut.is_along_bone);
}

}  // namespace
}  // namespace hallux::scenarios
