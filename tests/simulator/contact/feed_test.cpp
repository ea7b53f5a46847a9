#include "simulator/contact/feed.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/simulator/contact/feed_force.h"

namespace hallux::simulator {
namespace {

using tests::feed_force_newton;

constexpr double full_speed = law_cycles_per_minute;

TEST(Feed, TenNewtonOnTenMillimetresOfCortexAdvanceAtTheRateOfTheLaw) {
  // 0.35 (10 - 1.5) / 10
  EXPECT_NEAR(feed_rate_mm_s({10.0, 0.0}, 10.0, full_speed), 0.2975, 1e-12);
}

TEST(Feed, TenNewtonOnTenMillimetresOfCancellousBoneAdvanceAtTheRateOfTheLaw) {
  // 2 (10 - 0.3) / 10
  EXPECT_NEAR(feed_rate_mm_s({0.0, 10.0}, 10.0, full_speed), 1.94, 1e-12);
}

TEST(Feed, IsNeverFasterThanItsCeiling) {
  EXPECT_EQ(feed_rate_mm_s({0.0, 1.0}, 30.0, full_speed), feed_rate_limit_mm_s);
  EXPECT_EQ(feed_rate_mm_s({0.0, 0.0}, 30.0, full_speed), feed_rate_limit_mm_s);
}

TEST(Feed, StandsStillUpToTheThreshold) {
  EXPECT_EQ(feed_rate_mm_s({10.0, 0.0}, cortical_threshold_newton, full_speed), 0.0);
  EXPECT_EQ(feed_rate_mm_s({0.0, 10.0}, cancellous_threshold_newton, full_speed), 0.0);
  EXPECT_GT(feed_rate_mm_s({10.0, 0.0}, cortical_threshold_newton + 0.01, full_speed), 0.0);
  EXPECT_EQ(feed_rate_mm_s({10.0, 0.0}, -5.0, full_speed), 0.0);
}

TEST(Feed, IsProportionalToTheSpeedOfTheSaw) {
  EXPECT_NEAR(feed_rate_mm_s({10.0, 0.0}, 10.0, 0.5 * full_speed), 0.5 * 0.2975, 1e-12);
}

TEST(Feed, OfBoneOfAnotherQualityNeedsThatShareOfTheForce) {
  const Engagement mixed{3.0, 5.0};
  for (const double quality : {0.5, 0.8, 1.5}) {
    EXPECT_NEAR(feed_rate_mm_s(mixed, quality * 6.0, full_speed, quality),
                feed_rate_mm_s(mixed, 6.0, full_speed), 1e-12);
  }
  // 0.35 / 1.5 (10 - 1.5 x 1.5) / 10
  EXPECT_NEAR(feed_rate_mm_s({10.0, 0.0}, 10.0, full_speed, 1.5), 0.35 / 1.5 * 7.75 / 10.0, 1e-12);
  EXPECT_EQ(feed_rate_mm_s({10.0, 0.0}, 2.2, full_speed, 1.5), 0.0);
  EXPECT_EQ(feed_rate_mm_s(mixed, 6.3, full_speed, 1.0), feed_rate_mm_s(mixed, 6.3, full_speed));
}

RC_GTEST_PROP(Feed, ForceOfARateIsTheInverseOfTheRateOfAForce, ()) {
  const double cortical_mm = *rc::gen::inRange(0, 10000) * 0.001;
  const double cancellous_mm = *rc::gen::inRange(1, 10000) * 0.001;
  const double rate_mm_s = *rc::gen::inRange(1, 4999) * 0.001;
  const double cycles_per_minute = *rc::gen::inRange(5000, 20000);
  const Engagement engaged{cortical_mm, cancellous_mm};
  const double force_newton = feed_force_newton(engaged, rate_mm_s, cycles_per_minute);
  const double back_mm_s = feed_rate_mm_s(engaged, force_newton, cycles_per_minute);
  // The threshold (at most 1.5 N) is added and taken off again, and the rest divided: a few
  // roundings of the force.
  RC_ASSERT(std::abs(back_mm_s - rate_mm_s) <= 1e-12 * force_newton * (1.0 + rate_mm_s));
}

RC_GTEST_PROP(Feed, MoreForceNeverFeedsSlower, ()) {
  const Engagement engaged{*rc::gen::inRange(0, 10000) * 0.001,
                           *rc::gen::inRange(0, 10000) * 0.001};
  const double force_newton = *rc::gen::inRange(0, 30000) * 0.001;
  const double more_newton = force_newton + *rc::gen::inRange(0, 10000) * 0.001;
  RC_ASSERT(feed_rate_mm_s(engaged, force_newton, full_speed) <=
            feed_rate_mm_s(engaged, more_newton, full_speed));
}

}  // namespace
}  // namespace hallux::simulator
