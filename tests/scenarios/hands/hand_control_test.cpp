// What a hand is made of, each by itself: push, senses, and an axis that is held.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/hands/hand_senses.h"
#include "scenarios/hands/held_axis.h"
#include "scenarios/hands/push_control.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

TEST(PushControl, KeepsUpWithTheTeethWhereThePushIsRight) {
  const Push push;
  EXPECT_DOUBLE_EQ(handle_speed_mm_s(push, 15.0, 15.0, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(handle_speed_mm_s(push, 15.0, 14.0, 0.0), 1.0 / push.brace_newton_s_per_mm);
}

TEST(PushControl, RunsOnNoFasterThanItLeans) {
  const Push push;
  EXPECT_DOUBLE_EQ(handle_speed_mm_s(push, 29.0, 0.0, 5.0), push.lean_mm_s);
  EXPECT_LT(handle_speed_mm_s(push, 2.0, 29.0, 0.0), -push.lean_mm_s);
}

TEST(PushControl, OfAnUnevenHandVariesByItsShare) {
  const Push push{.unevenness = 0.25};
  WantedPush wanted(push, Random(1, "push"));
  double sum = 0.0, squares = 0.0;
  constexpr int count = 200'000;
  for (int i = 0; i < count; ++i) {
    const double share = wanted.next_newton(10.0, 1.0, step_s) / 10.0 - 1.0;
    sum += share;
    squares += share * share;
  }
  EXPECT_NEAR(sum / count, 0.0, 0.05);
  // Normal numbers that are cut at 2.5 deviations deviate by 0.95 of what was asked.
  EXPECT_NEAR(std::sqrt(squares / count), 0.95 * 0.25, 0.03);
}

TEST(PushControl, OfAnImpatientHandGrowsWhereNothingMovesAndCalmsDown) {
  const Push push{.unevenness = 0.0, .impatience_newton_per_s = 2.0};
  WantedPush wanted(push, Random(1, "push"));
  double newton = 0.0;
  for (int i = 0; i < 3000; ++i) newton = wanted.next_newton(10.0, 0.1, step_s);
  EXPECT_NEAR(newton, 16.0, 0.01);
  for (int i = 0; i < 1000; ++i) newton = wanted.next_newton(10.0, 1.0, step_s);
  EXPECT_NEAR(newton, 14.0, 0.01);
  wanted.calm_down();
  EXPECT_NEAR(wanted.next_newton(10.0, 1.0, step_s), 10.0, 0.01);
}

TEST(HandSenses, NoticeAReactionTimeLater) {
  HandSenses senses({.reaction_s = 0.2, .eye_mm = 0.0}, Random(1, "eye"));
  for (int tick = 0; tick < 1000; ++tick) {
    senses.observe({.push_newton = static_cast<double>(tick)}, 1);
    EXPECT_EQ(senses.noticed().push_newton, std::max(0, tick - 200));
  }
}

TEST(HandSenses, CountTheTicksThatALineCovers) {
  HandSenses senses({.reaction_s = 0.2, .eye_mm = 0.0}, Random(1, "eye"));
  for (int tick = 0; tick < 999; tick += 3) {
    senses.observe({.push_newton = static_cast<double>(tick)}, 3);
  }
  EXPECT_NEAR(senses.noticed().push_newton, 996.0 - 200.0, 3.0);
}

TEST(HandSenses, SeeTheDepthAsWellAsTheEyeIs) {
  HandSenses senses({.reaction_s = 0.1, .eye_mm = 0.5}, Random(1, "eye"));
  double squares = 0.0, largest_mm = 0.0;
  constexpr int count = 400'000;
  for (int i = 0; i < count; ++i) {
    senses.observe({.feed_mm = 7.0}, 1);
    const double error_mm = senses.noticed().feed_mm - 7.0;
    squares += error_mm * error_mm;
    largest_mm = std::max(largest_mm, std::abs(error_mm));
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.95 * 0.5, 0.06);
  EXPECT_GT(largest_mm, 1.0);
}

TEST(HandSenses, FollowTheTeeth) {
  HandSenses senses({.reaction_s = 0.1, .eye_mm = 0.3}, Random(1, "eye"));
  for (int tick = 0; tick < 2000; ++tick) senses.observe({.feed_mm = 0.002 * tick}, 1);
  EXPECT_NEAR(senses.noticed_feed_mm_s(), 2.0, 0.01);
}

/// Over two minutes, of an axis that is noticed a reaction time late.
double mean_square_mm2(double steadying_per_s, std::size_t reaction_ticks) {
  HeldAxis axis(Random(3, "axis"), 1.0, steadying_per_s);
  std::vector<double> past;
  double sum_mm2 = 0.0;
  for (std::size_t tick = 0; tick < 120'000; ++tick) {
    past.push_back(axis.value());
    const double noticed = past[tick < reaction_ticks ? 0 : tick - reaction_ticks];
    axis.hold(second_from_tick(static_cast<std::int64_t>(tick)), step_s, noticed);
    sum_mm2 += axis.value() * axis.value();
  }
  return sum_mm2 / 120'000.0;
}

TEST(HeldAxis, WandersLessWhereItIsUndone) {
  const double left_alone_mm2 = mean_square_mm2(0.0, 180);
  EXPECT_GT(left_alone_mm2, 0.1);
  EXPECT_LT(mean_square_mm2(1.5, 180), 0.85 * left_alone_mm2);
}

TEST(HeldAxis, ComesToWhatItMeansWhileItIsWatched) {
  HeldAxis axis(Random(3, "axis"), 1.0, 3.0);
  axis.mean(0.4);
  for (int tick = 0; tick < 1000; ++tick) axis.bring(second_from_tick(tick), step_s);
  EXPECT_NEAR(axis.value(), 0.4, 0.06);
}

TEST(HeldAxis, GoesOnFromWhereItIsPut) {
  HeldAxis axis(Random(3, "axis"), 1.0, 0.0);
  for (int tick = 0; tick < 3000; ++tick) axis.hold(second_from_tick(tick), step_s, 0.0);
  axis.put(-0.2);
  EXPECT_NEAR(axis.value(), -0.2, 1.0e-12);
}

}  // namespace
}  // namespace hallux::scenarios
