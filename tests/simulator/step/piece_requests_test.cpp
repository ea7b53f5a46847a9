#include "simulator/step/piece_requests.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

constexpr BladePassage cutting{.kerf_before = 0, .kerf_after = 0, .has_opened = true};
constexpr BladePassage leaving{.kerf_before = 0, .kerf_after = -1};

TEST(PieceRequests, AreDueWhenTheBladeLeavesAKerfInWhichItCut) {
  PieceRequests requests;
  requests.watch(cutting);
  EXPECT_TRUE(requests.has_opened());
  EXPECT_FALSE(requests.ask());
  requests.watch(leaving);
  EXPECT_TRUE(requests.ask());
  EXPECT_EQ(requests.last_opened(), 0);
  EXPECT_FALSE(requests.has_opened());
}

TEST(PieceRequests, AreDueWhenTheBladeLeavesTheBoneBehindIt) {
  PieceRequests requests;
  requests.watch({.kerf_before = 1, .kerf_after = 1, .has_opened = true, .broke_through = true});
  EXPECT_TRUE(requests.ask());
  EXPECT_EQ(requests.last_opened(), 1);
}

TEST(PieceRequests, AreNotDueWhereNothingWasOpened) {
  PieceRequests requests;
  requests.watch(leaving);
  requests.watch({.broke_through = true});
  EXPECT_FALSE(requests.is_wanted());
  EXPECT_EQ(requests.last_opened(), -1);
}

TEST(PieceRequests, GoOneAtATime) {
  PieceRequests requests;
  requests.watch(cutting);
  requests.watch(leaving);
  EXPECT_TRUE(requests.ask());
  EXPECT_TRUE(requests.is_waiting());
  requests.watch(cutting);
  requests.watch(leaving);
  EXPECT_FALSE(requests.ask());
  EXPECT_TRUE(requests.is_wanted());
  requests.apply();
  EXPECT_TRUE(requests.ask());
}

}  // namespace
}  // namespace hallux::simulator
