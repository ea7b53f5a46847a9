#include "simulator/record/display_fact.h"

#include <gtest/gtest.h>

#include <limits>

#include "simulator/record/channels.h"

namespace hallux::simulator {
namespace {

TEST(DisplayFact, ComesBackFromItsColumns) {
  std::array<std::int64_t, display_columns> columns{};
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = static_cast<std::int64_t>(i) + 7;
  EXPECT_EQ(columns_of(display_fact_from(columns)), columns);
}

TEST(DisplayFact, IsAViewByItsNumbersAlone) {
  EXPECT_TRUE(is_view(DisplayFact{}));
  const DisplayFact whole;
  const auto columns = columns_of(whole);
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < 11; ++i) {
    for (const std::int64_t hostile : {most, -most - 1}) {
      auto altered = columns;
      altered[i] = hostile;
      EXPECT_FALSE(is_view(display_fact_from(altered))) << "column " << i;
    }
  }
  DisplayFact fact;
  fact.world_from_view_micro = {};
  EXPECT_FALSE(is_view(fact)) << "no rotation";
  fact = {};
  fact.magnification_milli = 0;
  EXPECT_FALSE(is_view(fact));
  fact = {};
  fact.layout = static_cast<ShownLayout>(9);
  EXPECT_TRUE(is_view(fact));
  EXPECT_FALSE(is_known(fact)) << "a newer program's";
}

TEST(DisplayFact, IsTheNearestToWhatWasShown) {
  ShownView view;
  view.target_in_world_mm = Vec3(80.0004, -20.0006, 3.5);
  view.world_from_view = normalised(Quat(1.0, 0.2, -0.3, 0.1));
  view.magnification = 7.6543;
  view.stereo = ShownStereo::Anaglyph;
  view.layout = ShownLayout::WithSection;
  const auto fact = fact_of(view, 1234);
  ASSERT_TRUE(fact.has_value());
  EXPECT_EQ(fact->tick, 1234);
  EXPECT_EQ(fact->target_in_world_um[1], -20'001);
  const ShownView again = shown_view_of(*fact);
  EXPECT_LT(glm::length(again.target_in_world_mm - view.target_in_world_mm), 0.001);
  EXPECT_NEAR(glm::dot(again.world_from_view, view.world_from_view), 1.0, 1.0e-9);
  EXPECT_NEAR(again.magnification, view.magnification, 0.0005);
  EXPECT_EQ(fact_of(again, 1234), fact);
}

TEST(DisplayFact, OfNumbersThatAreNoneIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ShownView view;
  view.target_in_world_mm.y = nan;
  EXPECT_FALSE(fact_of(view, 0));
  view = {};
  view.world_from_view.x = nan;
  EXPECT_FALSE(fact_of(view, 0));
  view = {};
  view.magnification = 0.0;
  EXPECT_FALSE(fact_of(view, 0));
  view = {};
  view.magnification = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(fact_of(view, 0));
  EXPECT_FALSE(fact_of({}, -1));
}

TEST(DisplayFact, HasRoomForHalfAMinuteOfTurning) {
  AttemptChannels channels{4};
  int taken = 0;
  while (channels.display_facts.push({})) ++taken;
  EXPECT_EQ(taken, 256);
}

}  // namespace
}  // namespace hallux::simulator
