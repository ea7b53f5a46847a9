/// A guide leads to the plane of the step at hand, half a kerf into the waste.
#include "scenarios/planned_guide.h"
#include "tests/scenarios/format_1/format_1.h"

#include <gtest/gtest.h>

namespace hallux::scenarios {
namespace {

using simulator::Guidance;

/// A plan whose faces are known: it need not lie on a bone.
Plan plan_of(const Scenario& scenario) {
  Plan plan;
  for (std::size_t cut = 0; cut < scenario.cuts.size(); ++cut) {
    PlannedCut& planned = plan.cuts.emplace_back();
    planned.name = scenario.cuts[cut].name;
    planned.face = {Vec3(1.0, 0.0, 0.0), 10.0 + static_cast<double>(cut)};
  }
  return plan;
}

TEST(PlannedGuide, LeadsToTheCutOfTheStepAndWhileLookingToTheNext) {
  const Scenario akin = scenarios_test::format_1("akin");
  const auto planes = planned_guide(akin, plan_of(akin), simulator::Bone{}, Guidance::Soft).of_step;
  const double half_kerf_mm = 0.5 * akin.saw.blade.kerf_mm;
  ASSERT_TRUE(planes[0] && planes[1] && planes[2]);
  EXPECT_EQ(planes[0]->offset_mm, 10.0 + half_kerf_mm) << "looking, before the first cut";
  EXPECT_EQ(planes[1]->offset_mm, 10.0 + half_kerf_mm);
  EXPECT_EQ(planes[2]->offset_mm, 11.0 + half_kerf_mm);
  EXPECT_EQ(planes[2]->normal_in_bone, Vec3(1.0, 0.0, 0.0));
  for (std::size_t step = 3; step < planes.size(); ++step) EXPECT_FALSE(planes[step]) << step;
}

TEST(PlannedGuide, OfNobodyWhoAskedForOneIsEmpty) {
  const Scenario akin = scenarios_test::format_1("akin");
  const simulator::GuidePlan guide =
      planned_guide(akin, plan_of(akin), simulator::Bone{}, Guidance::None);
  EXPECT_EQ(guide.guidance, Guidance::None);
  for (const auto& plane : guide.of_step) EXPECT_FALSE(plane);
}

}  // namespace
}  // namespace hallux::scenarios
