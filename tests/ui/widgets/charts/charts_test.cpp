#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/charts/line_chart.h"
#include "ui/widgets/charts/timeline.h"

namespace hallux::ui {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

TEST(Axis, StepsByOneTwoOrFive) {
  EXPECT_EQ(nice_ticks(0.0, 100.0, 6), (std::vector<double>{0, 20, 40, 60, 80, 100}));
  EXPECT_EQ(nice_ticks(0.0, 3.4, 5), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(nice_ticks(0.5, 16.5, 20),
            (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}));
}

RC_GTEST_PROP(Axis, TicksLieInsideAndAreFew, ()) {
  const double low = *rc::gen::inRange(-1000, 1000), width = *rc::gen::inRange(1, 100000) * 0.01;
  const int most = *rc::gen::inRange(2, 12);
  const std::vector<double> ticks = nice_ticks(low, low + width, most);
  RC_ASSERT(!ticks.empty());
  RC_ASSERT(static_cast<int>(ticks.size()) <= most);
  RC_ASSERT(ticks.front() >= low - width * 1e-6);
  RC_ASSERT(ticks.back() <= low + width * (1.0 + 1e-6));
}

TEST(Axis, WritesNoMoreDecimalsThanTheStepHas) {
  EXPECT_EQ(tick_text(20.0, 20.0), "20");
  EXPECT_EQ(tick_text(0.5, 0.5), "0.5");
  EXPECT_EQ(tick_text(-2.0, 1.0),
            "\xE2\x88\x92"
            "2");
  EXPECT_EQ(tick_text(-1e-12, 0.1), "0.0");
}

TEST(Lines, AreNeverDrawnThroughAGap) {
  const Plot plot{{0, 0, 100, 100}, 0, 10, 0, 10};
  const std::vector<ChartPoint> points{{0, 1},   {1, 2},   {2, gap}, {3, 4},
                                       {4, gap}, {5, gap}, {6, 7},   {7, 8}};
  const auto runs = line_runs(plot, points);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].size(), 2U);
  EXPECT_EQ(runs[1].size(), 1U);
  EXPECT_EQ(runs[2].back(), (Point{70, 20}));
}

TEST(Lines, KeepEveryPeakWhereManySamplesShareAColumn) {
  const Plot plot{{0, 0, 200, 100}, 0, 1, 0, 100};
  std::vector<ChartPoint> points;
  for (int k = 0; k <= 200000; ++k)
    points.push_back({k / 200000.0, k == 77777 ? 95.0 : k == 123456 ? 3.0 : 50.0});
  const auto runs = line_runs(plot, points);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_LE(runs[0].size(), 4U * 201U);
  float highest = 100.0F, lowest = 0.0F;
  for (const Point& point : runs[0])
    highest = std::min(highest, point.y), lowest = std::max(lowest, point.y);
  EXPECT_FLOAT_EQ(highest, 5.0F);
  EXPECT_FLOAT_EQ(lowest, 97.0F);
}

LineChart small_chart() {
  LineChart chart;
  chart.y_unit = "Points", chart.x_name = "Attempt";
  chart.x_low = 0.5, chart.x_high = 3.5;
  chart.series = {{SeriesRole::You, "attempt", {{1, 20}, {2, gap}, {3, 60}}, false, true}};
  chart.pass_mark = 70.0, chart.pass_name = "pass 70 & more";
  return chart;
}

TEST(LineCharts, FindThePointThatIsPointedAt) {
  const LineChart chart = small_chart();
  const Rect rect{100, 100, 500, 300};
  const Plot plot = plot_of(rect, chart);
  EXPECT_EQ(point_near(rect, chart, {plot.x(1.0) + 5.0F, 300}), 0U);
  EXPECT_EQ(point_near(rect, chart, {plot.x(3.0) - 5.0F, 300}), 2U);
  EXPECT_EQ(point_near(rect, chart, {plot.x(2.0), 300}), std::nullopt)
      << "nothing was measured there";
  EXPECT_EQ(point_near(rect, chart, {50, 300}), std::nullopt);
}

TEST(LineCharts, NameTheirAxesAndTheMarkToPass) {
  const Texts texts("");
  Driver driver(texts, [](Ui& ui) {
    draw_line_chart(ui.canvas(), ui.theme(), {40, 40, 600, 400}, small_chart());
  });
  for (const char* words : {"pass 70 & more", "Points", "Attempt"})
    EXPECT_TRUE(driver.sees(words)) << words;
  EXPECT_FALSE(driver.sees("nan"));
  EXPECT_THAT(driver.faults(), testing::IsEmpty());
}

TEST(Timelines, TellTheMomentUnderThePointer) {
  Timeline timeline;
  timeline.duration_s = 236.0;
  const Rect rect{0, 0, 1000, 200};
  EXPECT_EQ(time_at(rect, timeline, -50.0F), 0.0);
  EXPECT_EQ(time_at(rect, timeline, 2000.0F), 236.0);
  EXPECT_NEAR(time_at(rect, timeline, 124.0F + 868.0F / 2.0F), 118.0, 0.5);
}

TEST(Timelines, WriteClockTimes) {
  EXPECT_EQ(clock_text(0.0), "00:00");
  EXPECT_EQ(clock_text(151.9), "02:31");
  EXPECT_EQ(clock_text(3751.0), "1:02:31");
}

TEST(Timelines, ShowWhatWasHappeningAtThePlayhead) {
  Timeline timeline;
  timeline.duration_s = 100.0, timeline.now_s = 50.0;
  timeline.steps_name = "Steps", timeline.events_name = "Events";
  timeline.steps = {{0, 40, "Mark"}, {40, 100, "Cut 1"}};
  timeline.tracks = {{"Force", "N", {{0, 1}, {50, gap}, {100, 3}}, {}, 30.0, 15.0}};
  const Texts texts("");
  Driver driver(texts, [&](Ui& ui) {
    draw_timeline(ui.canvas(), ui.theme(), {40, 40, 1000, timeline_height(timeline)}, timeline);
  });
  EXPECT_TRUE(driver.sees("Cut 1"));
  EXPECT_TRUE(driver.sees("00:50"));
  EXPECT_FALSE(driver.sees("nan"));
}

TEST(Timelines, HaveNoPlayheadWhereNothingIsPlayedAndScalesThatNeedNotBeginAtNothing) {
  Timeline timeline;
  timeline.duration_s = 10.0, timeline.now_s = std::nullopt;
  timeline.steps_name = "Steps", timeline.events_name = "Events";
  timeline.tracks = {{"Heat", "C", {{0, 37}, {10, 60}}, 80.0, 47.0, 20.0}};
  const Texts texts("");
  Driver driver(texts, [&](Ui& ui) {
    draw_timeline(ui.canvas(), ui.theme(), {40, 40, 1000, timeline_height(timeline)}, timeline);
  });
  for (const char* tick : {"20", "50", "80"}) EXPECT_TRUE(driver.sees(tick)) << tick;
  const int corners = driver.ui().draw_data().TotalVtxCount;
  timeline.now_s = 5.0;
  driver.frame();
  EXPECT_GT(driver.ui().draw_data().TotalVtxCount, corners) << "the playhead";
}

}  // namespace
}  // namespace hallux::ui
