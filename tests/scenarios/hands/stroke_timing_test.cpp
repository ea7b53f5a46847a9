#include "scenarios/hands/stroke_timing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

constexpr double width_mm = 12.0;
constexpr double law_cycles_per_minute = 12000.0;
/// Through the block along x, its tooth line within the block's 40 mm along y. No stride ends on the block's surface.
constexpr Stroke middle{0.0, -11.05, 10.0};
/// Feed is predicted stride by stride: where a tissue or the push changes, a stride's time is uncertain.
constexpr double stride_mm = 0.1;

/// 20 mm along the feed; all hard, or all soft where the law's cortex is thinner than any tooth's depth.
Bone block(bool is_soft) {
  Bone bone;
  bone.outer = tests::solid_block({20.0, 40.0, 10.0});
  if (is_soft) bone.cortex = simulator::CortexLaw{.mid_mm = 1.0e-6, .floor_mm = 1.0e-6};
  return bone;
}

std::vector<FeedMoment> feed_through(const Bone& bone, const Stroke& stroke, const Push& push,
                                     double cycles_per_minute = law_cycles_per_minute,
                                     std::span<const Stroke> earlier = {}) {
  const simulator::TissueMap tissue(bone);
  return predict_feed(stroke, earlier, simulator::KerfPlane{{}, 0.5}, tissue, width_mm,
                      cycles_per_minute, push);
}

// source  docs/haptics.md, the numbers written out: rate = K (F - F0) / width.
constexpr double cortical_mm_s(double push_newton) { return 0.35 * (push_newton - 1.5) / 12.0; }
constexpr double cancellous_mm_s(double push_newton) { return 2.0 * (push_newton - 0.3) / 12.0; }
constexpr double air_mm_s = 3.0;

TEST(StrokeTiming, ThroughHardBoneIsTheFeedLawByHand) {
  const double time_s = feed_through(block(false), middle, {15.0, 8.0, 2.5}).back().time_s;
  const double expected_s = 1.05 / air_mm_s + 17.5 / cortical_mm_s(15.0) + 2.5 / cortical_mm_s(8.0);
  EXPECT_NEAR(time_s, expected_s, 2.0 * stride_mm / cortical_mm_s(8.0));
}

TEST(StrokeTiming, ThroughSoftBoneIsTheFeedLawByHand) {
  const double time_s = feed_through(block(true), middle, {15.0, 8.0, 2.5}).back().time_s;
  const double expected_s =
      1.05 / air_mm_s + 17.5 / cancellous_mm_s(15.0) + 2.5 / cancellous_mm_s(8.0);
  EXPECT_NEAR(time_s, expected_s, 2.0 * stride_mm / cancellous_mm_s(8.0));
}

TEST(StrokeTiming, OfATwiceAsFastSawTakesHalfTheTimeInBone) {
  const Push push{15.0, 15.0, 0.0};
  const Stroke inside{0.0, -9.0, 9.0};
  const double once_s = feed_through(block(false), inside, push).back().time_s;
  const double twice_s =
      feed_through(block(false), inside, push, 2.0 * law_cycles_per_minute).back().time_s;
  EXPECT_NEAR(once_s, 2.0 * twice_s, 1.0e-9 * once_s);
}

TEST(StrokeTiming, SharesThePushAmongTheTeethThatMeetBone) {
  // The tooth line's middle stands on the block's side: ten or eleven of 21 teeth are in bone.
  const Push push{15.0, 15.0, 0.0};
  const double whole_s = feed_through(block(false), {0.0, -9.0, 9.0}, push).back().time_s;
  const double half_s = feed_through(block(false), {20.0, -9.0, 9.0}, push).back().time_s;
  EXPECT_GT(half_s / whole_s, 9.9 / 21.0);
  EXPECT_LT(half_s / whole_s, 11.1 / 21.0);
}

TEST(StrokeTiming, DoesNotSawAgainWhatAnEarlierStrokeOpened) {
  const Push push{15.0, 15.0, 0.0};
  const Stroke earlier{0.0, -11.05, 0.0};
  const double time_s =
      feed_through(block(false), middle, push, law_cycles_per_minute, std::span(&earlier, 1))
          .back()
          .time_s;
  EXPECT_NEAR(time_s, 11.05 / air_mm_s + 10.0 / cortical_mm_s(15.0),
              2.0 * stride_mm / cortical_mm_s(15.0));
}

TEST(StrokeTiming, EasesThePushBeforeTheFarSurface) {
  for (const FeedMoment& moment : feed_through(block(false), middle, {15.0, 8.0, 2.5})) {
    if (moment.feed_mm < -10.0 || std::abs(moment.feed_mm - 7.5) < stride_mm) continue;
    EXPECT_EQ(moment.push_newton, moment.feed_mm > 7.5 ? 8.0 : 15.0) << moment.feed_mm;
  }
}

TEST(StrokeTiming, DoesNotLeanOnTheBladeBeforeItMeetsBone) {
  const Push push{15.0, 8.0, 2.5};
  const Stroke earlier{0.0, -11.05, 0.0};
  for (const FeedMoment& moment :
       feed_through(block(false), middle, push, law_cycles_per_minute, std::span(&earlier, 1))) {
    if (moment.feed_mm > 0.0) {
      EXPECT_GE(moment.push_newton, 8.0) << moment.feed_mm;
    } else {
      EXPECT_EQ(moment.push_newton, 0.0) << moment.feed_mm;
    }
  }
}

TEST(StrokeTiming, RunsFromTheFirstBoneToTheLastAndNeverBack) {
  const std::vector<FeedMoment> moments = feed_through(block(true), middle, {15.0, 8.0, 2.5});
  EXPECT_EQ(moments.front().feed_mm, middle.first_mm);
  EXPECT_EQ(moments.front().time_s, 0.0);
  EXPECT_GE(moments.back().feed_mm, middle.last_mm);
  EXPECT_LT(moments.back().feed_mm, middle.last_mm + stride_mm + 1.0e-9);
  for (std::size_t i = 1; i < moments.size(); ++i) {
    EXPECT_GT(moments[i].time_s, moments[i - 1].time_s);
    EXPECT_GT(moments[i].feed_mm, moments[i - 1].feed_mm);
    EXPECT_LE(moments[i].feed_mm - moments[i - 1].feed_mm,
              air_mm_s * (moments[i].time_s - moments[i - 1].time_s) + 1.0e-9);
  }
}

}  // namespace
}  // namespace hallux::scenarios
