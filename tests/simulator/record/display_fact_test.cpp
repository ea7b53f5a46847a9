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

TEST(DisplayFact, HasRoomForHalfAMinuteOfTurning) {
  AttemptChannels channels{4};
  int taken = 0;
  while (channels.display_facts.push({})) ++taken;
  EXPECT_EQ(taken, 256);
}

}  // namespace
}  // namespace hallux::simulator
