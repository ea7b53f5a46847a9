#include "ui/widgets/charts/time_range.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "ui/widgets/charts/mark_clusters.h"

namespace hallux::ui {
namespace {

constexpr double duration_s = 603.0;

TEST(TimeRanges, ZoomAboutWhatStaysWhereItIs) {
  const TimeRange nearer = zoomed({0.0, duration_s}, duration_s, 10.0, 380.0);
  EXPECT_NEAR(nearer.span_s(), 60.3, 1.0e-9);
  EXPECT_NEAR((380.0 - nearer.begin_s) / nearer.span_s(), 380.0 / duration_s, 1.0e-9);
  const TimeRange back = zoomed(nearer, duration_s, 0.1, 380.0);
  EXPECT_NEAR(back.begin_s, 0.0, 1.0e-9);
  EXPECT_TRUE(is_whole(back, duration_s));
  EXPECT_FALSE(is_whole(nearer, duration_s));
}

TEST(TimeRanges, ShowTheMarksTheyWereOpenedFor) {
  const TimeRange opened = around(380.0, 412.0, duration_s);
  EXPECT_LT(opened.begin_s, 380.0);
  EXPECT_GT(opened.end_s, 412.0);
  EXPECT_NEAR(opened.span_s(), 32.0 * 1.3, 1.0e-9);
  EXPECT_NEAR(around(5.0, 5.0, duration_s).span_s(), least_span_s, 1.0e-12);
}

TEST(TimeRanges, FollowThePlayheadOnlyWhereItLeaves) {
  const TimeRange range{100.0, 110.0};
  EXPECT_EQ(showing(range, duration_s, 104.0), range);
  const TimeRange on = showing(range, duration_s, 110.5);
  EXPECT_NEAR(on.begin_s, 109.0, 1.0e-9) << "it comes in at the left";
  const TimeRange back = showing(range, duration_s, 99.0);
  EXPECT_NEAR(back.end_s, 100.5, 1.0e-9);
  EXPECT_EQ(showing(range, duration_s, duration_s).end_s, duration_s);
}

RC_GTEST_PROP(TimeRanges, StayInsideWhateverIsAsked, ()) {
  const double length_s = *rc::gen::inRange(1, 4'000'000) * 0.001;
  TimeRange range{0.0, length_s};
  for (int i = 0; i < 40; ++i) {
    const double any = *rc::gen::inRange(-1000, 1000) * 0.01 * length_s;
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        range = zoomed(range, length_s, *rc::gen::inRange(1, 1000) * 0.01, any);
        break;
      case 1:
        range = moved(range, length_s, any);
        break;
      case 2:
        range = around(any, any + length_s, length_s);
        break;
      default:
        range = showing(range, length_s, any);
    }
    RC_ASSERT(range.begin_s >= 0.0);
    RC_ASSERT(range.end_s <= length_s * (1.0 + 1.0e-12));
    RC_ASSERT(range.span_s() >= std::min(least_span_s, length_s) * (1.0 - 1.0e-9));
  }
}

TEST(MarkClusters, LeaveMarksAloneThatDoNotTouch) {
  const std::vector<PlacedMark> marks{{0.0F}, {30.0F}, {60.0F}};
  const auto clusters = clustered(marks);
  ASSERT_EQ(clusters.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(clusters[i].count, 1U);
    EXPECT_EQ(clusters[i].x, marks[i].x);
  }
}

TEST(MarkClusters, JoinAHeap) {
  std::vector<PlacedMark> marks;
  marks.reserve(201);
  for (int i = 0; i < 200; ++i) marks.push_back({100.0F + 0.1F * static_cast<float>(i)});
  marks.push_back({400.0F});
  const auto clusters = clustered(marks);
  ASSERT_EQ(clusters.size(), 2U);
  EXPECT_EQ(clusters[0].count, 200U);
  EXPECT_NEAR(clusters[0].x, 110.0F, 0.1F);
  EXPECT_EQ(clusters[1].first, 200U);
}

RC_GTEST_PROP(MarkClusters, HoldEachMarkOnceAndNeverTouch, ()) {
  std::vector<int> places = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 900));
  std::sort(places.begin(), places.end());
  std::vector<PlacedMark> marks;
  marks.reserve(places.size());
  for (const int place : places)
    marks.push_back({static_cast<float>(place), *rc::gen::element(2.0F, 8.0F, 10.0F)});
  std::size_t next = 0;
  const auto clusters = clustered(marks);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    RC_ASSERT(clusters[i].first == next);
    next += clusters[i].count;
    if (i > 0)
      RC_ASSERT(clusters[i].x - clusters[i].half_width >=
                clusters[i - 1].x + clusters[i - 1].half_width);
  }
  RC_ASSERT(next == marks.size());
}

}  // namespace
}  // namespace hallux::ui
