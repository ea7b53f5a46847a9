/// What the plots of docs/haptics.md say, held to be true.
#include "tests/simulator/device/wall_experiments.h"

#include <gtest/gtest.h>

namespace hallux::tests {
namespace {

constexpr double calm_mm = 0.05, thrown_mm = 1.0;

TEST(StabilityMap, AWallBelowFourFifthsOfTheoryIsCalmOnceItsForceIsLate) {
  for (const StabilityColumn& column : map_stability()) {
    if (column.delay_ticks == 0) continue;
    for (const StabilityCell& cell : column.cells) {
      if (cell.stiffness_newton_per_mm < 0.8 * column.theory_newton_per_mm) {
        EXPECT_LT(cell.plain_range_mm, calm_mm)
            << column.delay_ticks << " ticks, " << cell.stiffness_newton_per_mm;
      }
      if (cell.stiffness_newton_per_mm > 1.7 * column.theory_newton_per_mm) {
        EXPECT_GT(cell.plain_range_mm, thrown_mm)
            << column.delay_ticks << " ticks, " << cell.stiffness_newton_per_mm;
      }
    }
  }
}

TEST(StabilityMap, WithoutDelayTheMotorsEndBeforeTheoryDoes) {
  // A spring that never ends holds to its theory; a wall that is met throws the hand off at four
  // tenths of it, where the motors have no more force to give.
  const StabilityColumn column = map_stability()[0];
  EXPECT_GT(column.measured_newton_per_mm, 0.95 * column.theory_newton_per_mm);
  for (const StabilityCell& cell : column.cells) {
    if (cell.stiffness_newton_per_mm < 0.3 * column.theory_newton_per_mm) {
      EXPECT_LT(cell.plain_range_mm, calm_mm) << cell.stiffness_newton_per_mm;
    }
  }
}

TEST(StabilityMap, TheControllerHoldsThreeTimesWhatTheoryAllowsAtADelay) {
  for (const StabilityColumn& column : map_stability()) {
    if (column.delay_ticks == 0) continue;
    for (const StabilityCell& cell : column.cells) {
      if (cell.stiffness_newton_per_mm > 3.0 * column.theory_newton_per_mm) continue;
      EXPECT_LT(cell.passive_range_mm, calm_mm)
          << column.delay_ticks << " ticks, " << cell.stiffness_newton_per_mm;
    }
  }
}

TEST(ThreeLaws, AProxyAtAKilohertzComesToRestWhereForceIsStiffnessTimesDepth) {
  const PlateResult result = press_plate(PlateLaw::Proxy, 1);
  const double expected_mm = plate_push_newton / (plate_stiffness_newton_per_mm + 0.3);
  EXPECT_NEAR(result.rest_mm, expected_mm, 0.02 * expected_mm);
  EXPECT_LT(result.range_mm, 0.03);
  EXPECT_EQ(result.switches, 1) << "on, and never off";
}

TEST(ThreeLaws, TheSameSpringAtSixtyUpdatesASecondThrowsTheHandAbout) {
  const PlateResult result = press_plate(PlateLaw::Proxy, 17);
  EXPECT_GT(result.range_mm, 5.0);
  EXPECT_GT(result.switches, 30);
}

TEST(ThreeLaws, APenaltyLetsTheHandThroughAThinPlateAtAnyRate) {
  for (const std::int64_t ticks : {1, 17}) {
    const PlateResult result = press_plate(PlateLaw::Penalty, ticks);
    EXPECT_TRUE(result.has_fallen_through);
    EXPECT_GT(result.rest_mm, plate_mm) << "pushed out at the far side";
  }
}

TEST(ThreeLaws, TheHistoricLawNeverSettles) {
  const PlateResult frames = press_plate(PlateLaw::Thesis, 17);
  EXPECT_GT(frames.range_mm, 5.0);
  EXPECT_GT(frames.switches, 30);
  const PlateResult fast = press_plate(PlateLaw::Thesis, 1);
  EXPECT_GT(fast.switches, 300) << "at a kilohertz it chatters";
  EXPECT_GT(fast.speed_mm_s, 30.0);
}

}  // namespace
}  // namespace hallux::tests
