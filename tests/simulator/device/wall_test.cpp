/// An arm pressed against a wall in virtual time: where it comes to rest, how stiff the wall may
/// be, who pays the energy.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/simulator/device/wall_run.h"

namespace hallux::tests {
namespace {

using simulator::ArmTraits;
using simulator::ForceOutputSettings;
using simulator::HandGrip;

/// Half of the stiffness that the modelled device renders.
constexpr double half_of_the_stiffest = 1.5;
/// What an encoder step of 15 um hides of the account, at the device's 8 N.
constexpr double encoder_millijoule = 0.015 * 8.0;

WallRun pushed_by(double push_newton, std::int32_t transport_ticks) {
  WallRun run;
  run.arm.transport_ticks = transport_ticks;
  run.hand.push_newton.x = push_newton;
  return run;
}

TEST(Wall, IsEnteredByForceOverStiffnessWithinTwoPercent) {
  for (const double stiffness : {0.48, 1.0, half_of_the_stiffest}) {
    for (std::int32_t delay = 0; delay <= 2; ++delay) {
      const ForceOutputSettings output = output_for_wall(stiffness, delay);
      for (const double push_newton : {2.0, 4.0}) {
        const WallTrace trace =
            press(pushed_by(push_newton, delay), spring_wall(stiffness), &output);
        // The hand's own spring of 0.3 N/mm takes its part.
        const double expected_mm = push_newton / (stiffness + 0.3);
        EXPECT_NEAR(mean_mm(trace, 500), expected_mm, 0.02 * expected_mm)
            << stiffness << " N/mm, " << delay << " ticks, " << push_newton << " N";
      }
    }
  }
}

TEST(Wall, AHandThatTremblesComesToTheSameDepth) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    WallRun run = pushed_by(2.0, 1);
    run.tremor_mm = 0.05;
    run.seed = seed;
    const ForceOutputSettings output = output_for_wall(1.0, 1);
    const WallTrace trace = press(run, spring_wall(1.0), &output);
    EXPECT_NEAR(mean_mm(trace, 1000), 2.0 / 1.3, 0.02 * 2.0 / 1.3) << seed;
    EXPECT_LT(range_mm(trace, 1000), 0.2) << seed;
  }
}

TEST(Wall, IsCalmUpToHalfOfTheDevicesStiffnessWithUpToTwoTicksOfDelay) {
  for (std::int32_t delay = 0; delay <= 2; ++delay) {
    for (int tenth = 1; tenth <= 15; ++tenth) {
      const double stiffness = 0.1 * tenth;
      const ForceOutputSettings output = output_for_wall(stiffness, delay);
      for (const double push_newton : {1.0, 2.0, 4.0}) {
        const WallTrace trace =
            press(pushed_by(push_newton, delay), spring_wall(stiffness), &output);
        // Three encoder steps: a wall cannot be calmer than what it is made of.
        EXPECT_LE(range_mm(trace, 500), 0.045)
            << stiffness << " N/mm, " << delay << " ticks, " << push_newton << " N";
      }
    }
  }
}

TEST(Wall, NeverGivesBackMoreThanItTook) {
  EXPECT_TRUE(rc::check([] {
    const auto delay = static_cast<std::int32_t>(*rc::gen::inRange(0, 3));
    const double stiffness = 0.01 * *rc::gen::inRange(20, 151);
    WallRun run = pushed_by(0.1 * *rc::gen::inRange(1, 41), delay);
    run.start_mm = -0.1 * *rc::gen::inRange(0, 40);
    run.tremor_mm = 0.01 * *rc::gen::inRange(0, 6);
    run.seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
    run.ticks = 1500;
    const ForceOutputSettings output = output_for_wall(stiffness, delay);
    const WallTrace trace = press(run, spring_wall(stiffness), &output);
    RC_ASSERT(trace.least_of_wall_millijoule >= -encoder_millijoule);
    RC_ASSERT(trace.least_of_hand_millijoule >= -1.0e-9);
  }));
}

TEST(Wall, NeverGivesBackMoreThanItTookWhereLinesCoverTwoOrThreeTicks) {
  // A force that is held for three ticks comes later still.
  for (std::int64_t ticks_per_line = 2; ticks_per_line <= 3; ++ticks_per_line) {
    for (std::int32_t delay = 0; delay <= 2; ++delay) {
      ForceOutputSettings output = output_for_wall(half_of_the_stiffest, delay);
      for (const double push_newton : {1.0, 2.0, 4.0}) {
        SCOPED_TRACE(testing::Message() << ticks_per_line << " ticks a line, " << delay
                                        << " of transport, " << push_newton << " N");
        WallRun run = pushed_by(push_newton, delay);
        run.ticks_per_line = ticks_per_line;
        output.passivity.is_on = true;
        const WallTrace with = press(run, spring_wall(half_of_the_stiffest), &output);
        output.passivity.is_on = false;
        const WallTrace without = press(run, spring_wall(half_of_the_stiffest), &output);
        EXPECT_LT(without.least_of_wall_millijoule, -0.5);
        EXPECT_GE(with.least_of_hand_millijoule, -1.0e-9) << "the hand is given nothing";
        // Where all is latest and the push greatest the damper is too weak, and the arm's own takes
        // the rest: 6 mJ of 498.
        const bool is_worst = ticks_per_line == 3 && delay == 2 && push_newton > 2.0;
        EXPECT_GE(with.least_of_wall_millijoule, is_worst ? -6.5 : -encoder_millijoule);
      }
    }
  }
}

TEST(Wall, WithoutItsControllerItGivesEnergyAway) {
  const WallRun run = pushed_by(4.0, 2);
  ForceOutputSettings output = output_for_wall(half_of_the_stiffest, 2);
  const WallTrace with = press(run, spring_wall(half_of_the_stiffest), &output);
  output.passivity.is_on = false;
  const WallTrace without = press(run, spring_wall(half_of_the_stiffest), &output);
  EXPECT_GE(with.least_of_wall_millijoule, -encoder_millijoule);
  EXPECT_GE(with.least_of_hand_millijoule, -1.0e-9);
  EXPECT_LT(without.least_of_wall_millijoule, -10.0);
  EXPECT_LT(without.least_of_hand_millijoule, -5.0) << "more than the arm's own damping takes up";
}

TEST(Wall, ItsControllerHoldsAWallThatThrowsTheHandOff) {
  // Twice as stiff as may be, two ticks late.
  const WallRun run = pushed_by(2.0, 2);
  ForceOutputSettings output = output_for_wall(3.0, 2);
  const WallTrace with = press(run, spring_wall(3.0), &output);
  EXPECT_LT(range_mm(with, 500), 0.1);
  EXPECT_TRUE(has(with.limits, simulator::ForceLimit::Passivity));
  output.passivity.is_on = false;
  EXPECT_GT(range_mm(press(run, spring_wall(3.0), &output), 500), 5.0);
}

TEST(Wall, SlowWorkOnASpringIsNotDamped) {
  // A spring that is pressed and let go slowly takes and gives the same: nothing is to be
  // corrected.
  simulator::ForceOutputState state;
  state.started_share = 1.0;
  const ForceOutputSettings output = output_for_wall(1.0, 0);
  std::uint32_t limits = 0;
  for (int tick = 0; tick < 2000; ++tick) {
    const double depth_mm = 0.002 * (tick < 1000 ? tick : 2000 - tick);
    const auto given = output_force(state, output, {{-depth_mm, 0.0, 0.0}, {depth_mm, 0.0, 0.0}});
    // A tick late, 2 um over 2 mm are 0.004 mJ: an eighth of what the spring holds at 0.18 mm.
    if (depth_mm > 0.2) limits |= given.limits;
  }
  EXPECT_EQ(limits, 0U);
}

TEST(Wall, ItsGreatestStiffnessIsWhatTheoryAllows) {
  // Colgate and Schenkel: b > K T / 2 + |B|; with d ticks of transport b > K (T / 2 + d T). It is
  // what suffices for every hand, so this hand's limit lies above it, and not far.
  for (const double mass_kg : {0.1, 0.2}) {
    for (const double damping : {0.0005, 0.002, 0.005}) {
      for (std::int32_t delay = 0; delay <= 2; ++delay) {
        const ArmTraits arm{
            .mass_kg = mass_kg, .damping_newton_s_per_mm = damping, .transport_ticks = delay};
        const HandGrip hand;
        const double theory = (damping + hand.damping_newton_s_per_mm) / (0.001 * (0.5 + delay));
        const double ratio = stiffest_stable_wall(arm, hand) / theory;
        EXPECT_GT(ratio, 0.95) << mass_kg << " kg, " << damping << ", " << delay;
        EXPECT_LT(ratio, 1.20) << mass_kg << " kg, " << damping << ", " << delay;
      }
    }
  }
}

TEST(Wall, SixtyUpdatesASecondAllowATwentiethOfAThousand) {
  const ArmTraits arm{.transport_ticks = 1};
  const double thousand = stiffest_stable_wall(arm, HandGrip{});
  const double sixty = stiffest_stable_wall(arm, HandGrip{}, 17);
  EXPECT_LT(sixty, thousand / 5.0);
}

}  // namespace
}  // namespace hallux::tests
