#include "simulator/device/thermal_budget.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hallux::simulator {
namespace {

/// A small arm: 3.3 N for a moment, 0.88 N for ever.
constexpr ThermalSettings small_arm{0.88, 10.0};

/// The force that is given to one who always asks for that much, a value a millisecond.
std::vector<double> asked_for(double force_newton, int ticks, ThermalBudget& budget) {
  std::vector<double> given_newton;
  for (int tick = 0; tick < ticks; ++tick) {
    given_newton.push_back(std::min(force_newton, allowed_force_newton(budget, small_arm)));
    warm(budget, small_arm, given_newton.back(), 0.001);
  }
  return given_newton;
}

TEST(ThermalBudget, WarmsAsAFirstOrderBodyDoes) {
  ThermalBudget budget;
  for (int tick = 0; tick < 10000; ++tick) warm(budget, small_arm, 0.88, 0.001);
  EXPECT_NEAR(budget.heat, 1.0 - std::exp(-1.0), 1.0e-4) << "63 % after the thermal time";
}

TEST(ThermalBudget, TheContinuousForceIsGivenForEver) {
  ThermalBudget budget;
  const auto given_newton = asked_for(0.88, 200000, budget);
  EXPECT_EQ(*std::min_element(given_newton.begin(), given_newton.end()), 0.88);
  EXPECT_LE(budget.heat, 1.0);
}

TEST(ThermalBudget, TheGreatestForceLastsAsLongAsTheHeatAllowsAndSinksSlowly) {
  ThermalBudget budget;
  const auto given_newton = asked_for(3.3, 20000, budget);
  // 1 - exp(-t / 10 s) = (0.88 / 3.3)^2: 0.74 s from cold, and it begins to sink by the ease of 0.5
  // s before.
  const auto full_ticks =
      std::count_if(given_newton.begin(), given_newton.end(), [](double f) { return f == 3.3; });
  EXPECT_GT(full_ticks, 100);
  EXPECT_LT(full_ticks, 740);
  EXPECT_NEAR(given_newton.back(), 0.88, 0.001);
  for (std::size_t i = 1; i < given_newton.size(); ++i) {
    EXPECT_LE(given_newton[i - 1] - given_newton[i], 3.3 * 0.001) << "a ramp, never a step";
  }
}

TEST(ThermalBudget, RestGivesTheForceBack) {
  ThermalBudget budget;
  asked_for(3.3, 20000, budget);
  for (int tick = 0; tick < 60000; ++tick) warm(budget, small_arm, 0.0, 0.001);
  EXPECT_EQ(asked_for(3.3, 1, budget)[0], 3.3);
}

TEST(ThermalBudget, WhateverIsAskedForTheHeatStaysWithinItsLimit) {
  EXPECT_TRUE(rc::check([] {
    const ThermalSettings settings{0.1 * *rc::gen::inRange(1, 100),
                                   0.1 * *rc::gen::inRange(1, 300)};
    const auto asked =
        *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3000));  // hundredths of a newton
    ThermalBudget budget;
    double squares = 0.0, time_s = 0.0;
    for (const int force : asked) {
      const double given_newton = std::min(0.01 * force, allowed_force_newton(budget, settings));
      // Held for 60 ms, in ticks as long as they come.
      for (int i = 0; i < 20; ++i) {
        const double now_newton = std::min(given_newton, allowed_force_newton(budget, settings));
        warm(budget, settings, now_newton, 0.003);
        squares += 0.003 * now_newton * now_newton;
        time_s += 0.003;
        RC_ASSERT(budget.heat <= 1.0 + 1.0e-12);
      }
    }
    // The law integrated: the mean square of the force never exceeds the continuous one by more
    // than what a cold motor takes up.
    const double continuous = settings.continuous_force_newton;
    RC_ASSERT(squares <= continuous * continuous * (time_s + settings.thermal_time_s) + 1.0e-9);
  }));
}

}  // namespace
}  // namespace hallux::simulator
