#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/plan.h"
#include "tests/scenarios/format_1/format_1.h"

namespace hallux::scenarios {
namespace {

/// The shape is the same at any edge length; a coarse one is enough to see where the plane lies.
Scenario coarse_silver() {
  Scenario scenario = scenarios_test::format_1("silver");
  scenario.patient.edge_mm = 1.0;
  return scenario;
}

double distance_to_segment_mm(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double share = std::clamp(glm::dot(point - from, along) / glm::dot(along, along), 0.0, 1.0);
  const Vec3 gap = point - (from + share * along);
  return std::sqrt(glm::dot(gap, gap));
}

TEST(PatientPlan, OfSilverTakesTheEminenceAndKeepsTheHeadAndTheShaft) {
  const simulator::Bone patient = make_patient_bones(coarse_silver()).front();
  const PlannedCut cut = plan_on(coarse_silver(), patient).cuts.at(0);
  const auto height_mm = [&](std::string_view landmark) {
    const Vec3 point = simulator::find_landmark(patient, landmark).value();
    return glm::dot(cut.face.normal, point) - cut.face.offset_mm;
  };
  EXPECT_NEAR(height_mm("med_sulcus"), -1.0, 1.0e-12);
  // A typical resection is at least 3 mm thick.
  EXPECT_GT(height_mm("eminence_apex"), 3.0);
  EXPECT_LT(height_mm("head_centre"), 0.0);
  EXPECT_NEAR(height_mm("shaft_proximal"), height_mm("shaft_distal"), 1.0e-12);
  EXPECT_LT(height_mm("shaft_distal"), 0.0);
}

TEST(PatientPlan, OfSilverHasItsDangerZonesOutsideTheBone) {
  const Scenario silver = coarse_silver();
  const simulator::Bone patient = make_patient_bones(silver).front();
  for (const DangerZone& zone : silver.danger_zones) {
    double nearest_mm = 1000.0;
    for (const Vec3& point : patient.outer.points_mm) {
      nearest_mm = std::min(
          nearest_mm, distance_to_segment_mm(point, zone.from_in_bone_mm, zone.to_in_bone_mm));
    }
    EXPECT_GT(nearest_mm, zone.radius_mm) << zone.name;
  }
}

}  // namespace
}  // namespace hallux::scenarios
