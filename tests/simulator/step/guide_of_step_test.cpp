#include "simulator/step/guide_of_step.h"

#include <gtest/gtest.h>

#include <limits>

namespace hallux::simulator {
namespace {

/// Planes for the first step and the third.
GuidePlan two_planes() {
  GuidePlan plan;
  plan.guidance = Guidance::Slot;
  plan.of_step[0] = GuidePlane{Vec3(1.0, 0.0, 0.0), 4.0};
  plan.of_step[2] = GuidePlane{Vec3(0.0, 1.0, 0.0), 7.0};
  return plan;
}

TEST(GuideOfStep, IsThePlaneOfTheStepAtHand) {
  const GuidePlan plan = two_planes();
  GuideOfStep guide;
  EXPECT_EQ(guide.plane(plan), &*plan.of_step[0]);
  guide.finish_step(0);
  EXPECT_EQ(guide.plane(plan), nullptr);
  guide.finish_step(1);
  EXPECT_EQ(guide.plane(plan), &*plan.of_step[2]);
}

/// A plane that no plan has.
const GuidePlane sawn{Vec3(1.0, 0.0, 0.0), 4.6};

TEST(GuideOfStep, IsThePlaneOfTheStepsOwnKerfOnceItHasOneAndOfThePlanInTheNextStep) {
  const GuidePlan plan = two_planes();
  GuideOfStep guide;
  guide.note_own_kerf(sawn);
  ASSERT_NE(guide.plane(plan), nullptr);
  EXPECT_EQ(guide.plane(plan)->offset_mm, sawn.offset_mm);
  guide.finish_step(1);
  EXPECT_EQ(guide.plane(plan), &*plan.of_step[2]);
}

TEST(GuideOfStep, OfAStepTakenUpAgainIsItsOwnKerfsOrStillThePlans) {
  const GuidePlan plan = two_planes();
  GuideOfStep guide;
  guide.note_own_kerf(sawn);
  guide.finish_step(0);
  EXPECT_EQ(guide.plane(plan), nullptr);
  guide.reopen_step(0);
  ASSERT_NE(guide.plane(plan), nullptr);
  EXPECT_EQ(guide.plane(plan)->offset_mm, sawn.offset_mm);
  guide.reopen_step(2);
  EXPECT_EQ(guide.plane(plan), &*plan.of_step[2]);
}

TEST(GuideOfStep, IsNoneOfAStepWithoutAPlaneWhateverIsSawnInIt) {
  const GuidePlan plan = two_planes();
  GuideOfStep guide;
  guide.finish_step(0);
  guide.note_own_kerf(sawn);
  EXPECT_EQ(guide.plane(plan), nullptr);
  guide.finish_step(std::numeric_limits<std::int32_t>::max());
  guide.note_own_kerf(sawn);
  guide.reopen_step(-7);
  guide.note_own_kerf(sawn);
  EXPECT_EQ(guide.plane(plan), nullptr);
}

TEST(GuideOfStep, IsNoneWithoutGuidanceOrBeyondTheSteps) {
  GuidePlan plan = two_planes();
  GuideOfStep guide;
  for (const std::int32_t step :
       {std::numeric_limits<std::int32_t>::min(), -2, static_cast<std::int32_t>(63),
        std::numeric_limits<std::int32_t>::max()}) {
    guide.finish_step(step);
    EXPECT_EQ(guide.plane(plan), nullptr) << step;
  }
  guide.finish_step(-1);
  EXPECT_NE(guide.plane(plan), nullptr);
  plan.guidance = Guidance::None;
  EXPECT_EQ(guide.plane(plan), nullptr);
}

}  // namespace
}  // namespace hallux::simulator
