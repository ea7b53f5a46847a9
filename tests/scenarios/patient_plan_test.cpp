#include <gtest/gtest.h>

#include "scenarios/plan.h"

namespace hallux::scenarios {
namespace {

/// The shape is the same at any edge length; a coarse one is enough to see where the plane lies.
Scenario coarse_silver() {
  Scenario scenario = load_shipped_scenario("silver");
  scenario.patient.edge_mm = 1.0;
  return scenario;
}

TEST(PatientPlan, OfSilverTakesTheEminenceAndSparesTheShaftAxisAndTheGrooves) {
  const Scenario silver = coarse_silver();
  const simulator::Bone patient = make_patient(silver);
  const PlannedCut cut = plan_on(silver, patient).cuts.at(0);
  const auto height_mm = [&](const Vec3& point) {
    return glm::dot(cut.face.normal, point) - cut.face.offset_mm;
  };
  double highest_mm = -1.0;
  for (const Vec3& point : patient.outer.points_mm)
    highest_mm = std::max(highest_mm, height_mm(point));
  // A typical resection is 3 to 5 mm thick.
  EXPECT_GT(highest_mm, 2.5);
  EXPECT_LT(highest_mm, 6.0);
  EXPECT_NEAR(height_mm(cut.depth_point_in_bone_mm), -1.0, 1.0e-12);
  EXPECT_LT(height_mm(*simulator::find_landmark(patient, "shaft_distal")), -3.0);
  // The blade passes between the zones: each capsule stays clear of the slab that the kerf takes.
  for (const DangerZone& zone : silver.danger_zones) {
    EXPECT_GT(height_mm(zone.from_in_bone_mm) * height_mm(zone.to_in_bone_mm), 0.0) << zone.name;
  }
}

TEST(PatientPlan, OfTheSameScenarioIsTheSamePatientAgain) {
  const Scenario silver = coarse_silver();
  EXPECT_TRUE(make_patient(silver) == make_patient(silver));
}

}  // namespace
}  // namespace hallux::scenarios
