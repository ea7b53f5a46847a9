// A hand leads a fragment on from where it was shifted before, and turns it about its own place.
#include <gtest/gtest.h>

#include "scenarios/hands/hand_reach.h"
#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

constexpr double rounding = 1.0e-12;

RigidTransform slide(const Vec3& way_mm) { return {{1.0, 0.0, 0.0, 0.0}, way_mm}; }

TEST(ShiftAim, TurnsAFragmentThatWasShiftedBeforeAboutWhereItLies) {
  Plan plan;
  plan.fixation.fragments.push_back({.name = "head", .holds_in_bone_mm = {10.0, 0.0, 0.0}});
  plan.fixation.fragments.front().foot_dorsal_in_bone = {0.0, 1.0, 0.0};
  plan.fixation.shifts.push_back({.name = "again",
                                  .fragment = "head",
                                  .before_from_cut = slide({0.0, 0.0, 3.0}),
                                  .bone_from_before = slide({0.0, 0.0, 2.0})});
  const HandSkill skill = with_faults(hand_skill("perfect"), {{FaultKind::TurnBy, "head", 10.0}});
  const RigidTransform led = aim_shift(plan, 0, skill, 1);
  EXPECT_LT(length_of(transform_point(led, Vec3(10.0, 0.0, 3.0)) - Vec3(10.0, 0.0, 5.0)), rounding);
  const double half_rad = 0.5 * radian_from_degree(10.0);
  EXPECT_NEAR(led.rotation.y, elementary::sin(half_rad), rounding);
}

}  // namespace
}  // namespace hallux::scenarios
