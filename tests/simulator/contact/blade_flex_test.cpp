#include "simulator/contact/blade_flex.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

TEST(BladeFlex, OneNewtonBends20MillimetresOfAForefootBladeByAQuarterOfAMillimetre) {
  // 8000 / (3 x 200000 x 10 x 0.064 / 12)
  EXPECT_NEAR(deflection_mm({.free_length_mm = 20.0}, 1.0), 0.25, 1e-12);
}

TEST(BladeFlex, AThickerBladeSkivesLess) {
  EXPECT_NEAR(deflection_mm({.free_length_mm = 20.0, .thickness_mm = 0.6}, 1.0), 0.0741, 1e-4);
}

RC_GTEST_PROP(BladeFlex, DoubleTheLengthBendsEightTimesAsFarAndTheOtherWayForTheOtherSide, ()) {
  const BladeBeam beam{.free_length_mm = *rc::gen::inRange(1, 400) * 0.1};
  const double force_newton = *rc::gen::inRange(1, 100) * 0.1;
  BladeBeam longer = beam;
  longer.free_length_mm *= 2.0;
  const double once_mm = deflection_mm(beam, force_newton);
  RC_ASSERT(std::abs(deflection_mm(longer, force_newton) - 8.0 * once_mm) <= 1e-12 * once_mm);
  RC_ASSERT(deflection_mm(beam, -force_newton) == -once_mm);
}

class FreeLength : public ::testing::Test {
 protected:
  Bone bone_ = tests::cortical_bone(tests::solid_block({20.0, 20.0, 20.0}));
  TissueMap original_{bone_};
  KerfSet kerfs_{Blade{}, bone_.world_from_bone};
  Wound standing_{RemainingTissue{original_, kerfs_, {}}};
};

TEST_F(FreeLength, IsTheWholeBladeInAir) {
  EXPECT_EQ(free_length_mm(tests::blade_down({0.0, 12.0, 0.0}), 25.0, standing_), 25.0);
}

TEST_F(FreeLength, IsWhatStandsOutOfTheBone) {
  // The top lies at y = 10; eight of 25 millimetres are in.
  EXPECT_NEAR(free_length_mm(tests::blade_down({0.0, 2.0, 0.0}), 25.0, standing_), 17.0, 0.011);
}

TEST_F(FreeLength, EndsAtTheNearSideOfABoneThatIsSawnThrough) {
  EXPECT_NEAR(free_length_mm(tests::blade_down({0.0, -12.0, 0.0}), 25.0, standing_), 3.0, 0.011);
}

TEST_F(FreeLength, IsNothingWhereTheCollarIsInside) {
  EXPECT_EQ(free_length_mm(tests::blade_down({0.0, -9.0, 0.0}), 15.0, standing_), 0.0);
}

}  // namespace
}  // namespace hallux::simulator
