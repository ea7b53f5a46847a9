#include "ui/jobs/noted_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "simulator/base/units.h"

namespace hallux::ui {
namespace {

using simulator::DisplayFact;
using simulator::ShownView;

/// Turned to the right about the world's y.
ShownView turned(double degree) {
  const double half_rad = 0.5 * radian_from_degree(degree);
  ShownView view;
  view.world_from_view = Quat(std::cos(half_rad), 0.0, std::sin(half_rad), 0.0);
  return view;
}

struct Noted {
  explicit Noted(std::size_t room = 256) : ring(room), views(ring) {}
  std::vector<DisplayFact> take() {
    std::vector<DisplayFact> facts;
    for (DisplayFact fact; ring.pop(fact);) facts.push_back(fact);
    return facts;
  }

  simulator::Ring<DisplayFact> ring;
  NotedViews views;
};

TEST(NotedViews, KeepTheFirstAndThenOnlyWhatChanged) {
  Noted noted;
  for (std::int64_t tick = 20; tick < 5000; tick += 16) noted.views.note(turned(10.0), tick);
  const auto facts = noted.take();
  ASSERT_EQ(facts.size(), 1U);
  EXPECT_EQ(facts.front().tick, 20);
  noted.views.note(turned(10.2), 6000);
  EXPECT_TRUE(noted.take().empty()) << "nobody sees that";
  ShownView stereo = turned(10.0);
  stereo.stereo = simulator::ShownStereo::SideBySide;
  noted.views.note(stereo, 7000);
  EXPECT_EQ(noted.take().size(), 1U);
}

TEST(NotedViews, KeepATurnTenTimesASecondAndWhereItEnds) {
  Noted noted;
  double degree = 0.0;
  for (std::int64_t tick = 0; tick < 2000; tick += 16) {
    if (tick < 1000) degree = 0.05 * static_cast<double>(tick);
    noted.views.note(turned(degree), tick);
  }
  const auto facts = noted.take();
  EXPECT_GE(facts.size(), 9U);
  EXPECT_LE(facts.size(), 11U);
  for (std::size_t i = 1; i < facts.size(); ++i) EXPECT_GE(facts[i].tick - facts[i - 1].tick, 100);
  EXPECT_FALSE(is_noticeably_other(shown_view_of(facts.back()), turned(degree)));
}

TEST(NotedViews, KeepASlowTurnToo) {
  Noted noted;
  for (std::int64_t tick = 0; tick < 10'000; tick += 16)
    noted.views.note(turned(0.0005 * static_cast<double>(tick)), tick);  // half a degree a second
  EXPECT_GE(noted.take().size(), 10U);
}

TEST(NotedViews, SeeEachWayInWhichAViewIsAnother) {
  const ShownView view;
  const auto is_other = [&](auto&& change) {
    ShownView changed = view;
    change(changed);
    return is_noticeably_other(view, changed);
  };
  EXPECT_FALSE(is_other([](ShownView&) {}));
  EXPECT_TRUE(is_other([](ShownView& v) { v.target_in_world_mm.x += 1.0; }));
  EXPECT_FALSE(is_other([](ShownView& v) { v.target_in_world_mm.x += 0.1; }));
  EXPECT_TRUE(is_other([](ShownView& v) { v.magnification *= 1.02; }));
  EXPECT_TRUE(is_other([](ShownView& v) { v.target_depth_mm += 1.0; }));
  EXPECT_TRUE(is_other([](ShownView& v) { v.width_over_height = 1.2; }));
  EXPECT_TRUE(is_other([](ShownView& v) { v.layout = simulator::ShownLayout::WithSection; }));
  EXPECT_FALSE(is_other([](ShownView& v) { v.world_from_view = -v.world_from_view; }))
      << "the same turn";
}

TEST(NotedViews, DropWhereTheRingIsFullAndCountIt) {
  Noted noted(2);
  for (int i = 0; i < 5; ++i) noted.views.note(turned(10.0 * i), 100 * i);
  auto facts = noted.take();
  ASSERT_EQ(facts.size(), 2U);
  EXPECT_EQ(facts.back().lost_before, 0);
  noted.views.note(turned(60.0), 900);
  noted.views.note(turned(70.0), 1000);
  facts = noted.take();
  ASSERT_EQ(facts.size(), 2U);
  EXPECT_EQ(facts[0].lost_before, 3);
  EXPECT_EQ(facts[1].lost_before, 0);
}

TEST(NotedViews, PassOverWhatIsNoView) {
  Noted noted;
  ShownView view;
  view.magnification = std::numeric_limits<double>::quiet_NaN();
  noted.views.note(view, 0);
  EXPECT_TRUE(noted.take().empty());
  noted.views.note({}, 10);
  EXPECT_EQ(noted.take().size(), 1U);
}

}  // namespace
}  // namespace hallux::ui
