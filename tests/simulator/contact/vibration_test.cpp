#include "simulator/contact/vibration.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hallux::simulator {
namespace {

std::vector<double> forces_of(const VibrationInput& input, int ticks, std::uint64_t seed = 7) {
  VibrationState state(seed);
  std::vector<double> forces(static_cast<std::size_t>(ticks));
  for (double& force : forces) force = vibrate(state, input);
  return forces;
}

double greatest(const std::vector<double>& forces) {
  double most = 0.0;
  for (const double force : forces) most = std::max(most, std::abs(force));
  return most;
}

int upward_crossings(const std::vector<double>& forces) {
  int count = 0;
  for (std::size_t i = 1; i < forces.size(); ++i) {
    if (forces[i - 1] < 0.0 && forces[i] >= 0.0) ++count;
  }
  return count;
}

TEST(Vibration, HasHalfTheRateOfTheSawWithinTheBand) {
  EXPECT_EQ(vibration_hz(12000.0), 100.0);
  EXPECT_EQ(vibration_hz(15000.0), 125.0);
  EXPECT_EQ(vibration_hz(5000.0), vibration_low_hz);
  EXPECT_EQ(vibration_hz(20000.0), vibration_high_hz);
}

TEST(Vibration, SwingsAsOftenAsItSays) {
  for (const double cycles_per_minute : {9000.0, 12000.0, 14400.0, 20000.0}) {
    const auto forces = forces_of(
        {.saw_runs = true, .cycles_per_minute = cycles_per_minute, .cutting_watt = 0.3}, 10000);
    EXPECT_NEAR(upward_crossings(forces), 10.0 * vibration_hz(cycles_per_minute), 2.0);
  }
}

TEST(Vibration, GrowsFromATenthOfANewtonInAirToHalfOneInCorticalBone) {
  const double free_newton = greatest(forces_of({.saw_runs = true}, 3000));
  const double full_newton = greatest(forces_of({.saw_runs = true, .cutting_watt = 0.9}, 3000));
  // The strongest of 300 cycles is near a tenth above, and one of its ten samples near the crest.
  EXPECT_GT(free_newton, 0.1 * 1.05 * 0.95);
  EXPECT_LE(free_newton, 0.1 * 1.1);
  EXPECT_GT(full_newton, 0.5 * 1.05 * 0.95);
  EXPECT_LE(full_newton, 0.5 * 1.1);
}

TEST(Vibration, IsFullAtTenNewtonOnTenMillimetresOfCortex) {
  const double feed_mm_s = feed_rate_mm_s({10.0, 0.0}, 10.0, 12000.0);
  EXPECT_NEAR(cutting_watt({10.0, 0.0}, 0.5, feed_mm_s), vibration_full_watt, 0.01);
  // Spongy bone yields more than six times as fast and costs a twelfth: about half the power.
  const double spongy_mm_s = feed_rate_mm_s({0.0, 10.0}, 10.0, 12000.0);
  EXPECT_NEAR(cutting_watt({0.0, 10.0}, 0.5, spongy_mm_s), 0.485, 0.01);
}

TEST(Vibration, OfASawThatStopsIsStillWithinItsSettlingTime) {
  VibrationState state(3);
  for (int i = 0; i < 500; ++i) vibrate(state, {.saw_runs = true, .cutting_watt = 2.0});
  double last = 1.0;
  for (int i = 0; i < 21; ++i) last = vibrate(state, {.saw_runs = false});
  EXPECT_EQ(last, 0.0);
  EXPECT_EQ(state.amplitude_newton, 0.0);
}

TEST(Vibration, OfASawThatNeverRanIsNothing) {
  EXPECT_EQ(greatest(forces_of({.saw_runs = false, .cutting_watt = 1.0}, 1000)), 0.0);
}

TEST(Vibration, HasNoMean) {
  const auto forces = forces_of({.saw_runs = true, .cutting_watt = 0.9}, 60000);
  double sum = 0.0;
  for (const double force : forces) sum += force;
  EXPECT_LT(std::abs(sum / 60000.0), 0.001);
}

TEST(Vibration, TheSameSeedTremblesAlikeAndAnotherOtherwise) {
  const VibrationInput input{.saw_runs = true, .cutting_watt = 0.5};
  EXPECT_EQ(forces_of(input, 2000, 11), forces_of(input, 2000, 11));
  EXPECT_NE(forces_of(input, 2000, 11), forces_of(input, 2000, 12));
}

RC_GTEST_PROP(Vibration, IsBoundedWhateverHappens, ()) {
  VibrationState state(*rc::gen::arbitrary<std::uint64_t>());
  for (int i = 0; i < 200; ++i) {
    VibrationInput input;
    input.saw_runs = *rc::gen::arbitrary<bool>();
    input.cycles_per_minute = *rc::gen::inRange(0, 40000);
    input.cutting_watt = *rc::gen::inRange(-1000, 10000) * 0.001;
    input.duration_s = *rc::gen::inRange(1, 4) * 0.001;
    RC_ASSERT(std::abs(vibrate(state, input)) <= vibration_full_newton * (1.0 + vibration_noise));
    RC_ASSERT(state.turns >= 0.0 && state.turns < 1.0);
  }
}

}  // namespace
}  // namespace hallux::simulator
