#include "simulator/step/piece_requests.h"

#include <gtest/gtest.h>

#include <array>

namespace hallux::simulator {
namespace {

KerfNumbers kerfs(std::initializer_list<std::int32_t> numbers) {
  KerfNumbers all;
  for (const std::int32_t number : numbers) all.add(number);
  return all;
}

constexpr BladePassage leaving{.kerf_before = 0, .kerf_after = -1};

/// Kerfs 0 and 1 are in the first of two bones, kerf 2 in the second.
class AskedPieces : public testing::Test {
 protected:
  AskedPieces() {
    for (const std::int32_t bone : {0, 0, 1}) set_.freeze({}, bone);
  }
  void cut(std::initializer_list<std::int32_t> numbers, std::int32_t kerf = 0) {
    requests_.watch({.kerf_before = kerf, .kerf_after = kerf, .opened = kerfs(numbers)});
  }
  std::int32_t ask() { return requests_.ask(set_); }

  std::array<RigidTransform, 2> world_from_bones_{};
  KerfSet set_{Blade{}, FragmentPoses(world_from_bones_)};
  PieceRequests requests_;
};

TEST_F(AskedPieces, AreDueWhenTheBladeLeavesAKerfInWhichItCut) {
  cut({0});
  EXPECT_TRUE(requests_.has_opened());
  EXPECT_EQ(ask(), -1);
  requests_.watch(leaving);
  EXPECT_EQ(ask(), 0);
  EXPECT_FALSE(requests_.has_opened());
}

TEST_F(AskedPieces, AreDueWhenTheBladeLeavesTheBoneBehindIt) {
  requests_.watch({.kerf_before = 1, .kerf_after = 1, .opened = kerfs({1}), .broke_through = true});
  EXPECT_EQ(ask(), 1);
}

TEST_F(AskedPieces, AreNotDueWhereNothingWasOpened) {
  requests_.watch(leaving);
  requests_.watch({.broke_through = true});
  EXPECT_FALSE(requests_.is_wanted());
  EXPECT_EQ(ask(), -1);
}

TEST_F(AskedPieces, OfABladeThatSawsOnInTwoFragmentsAreAskedOnceForEach) {
  cut({0, 2});
  requests_.watch({.kerf_before = 0, .kerf_after = 0, .broke_through = true});
  for (const std::int32_t kerf : {0, 2}) {
    EXPECT_EQ(ask(), kerf);
    requests_.apply();
    cut({0, 2});
  }
  EXPECT_EQ(ask(), -1) << "until it breaks through again, or leaves";
}

TEST_F(AskedPieces, GoOneAtATime) {
  cut({0});
  requests_.watch(leaving);
  EXPECT_EQ(ask(), 0);
  EXPECT_TRUE(requests_.is_waiting());
  cut({0});
  requests_.watch(leaving);
  EXPECT_EQ(ask(), -1);
  EXPECT_TRUE(requests_.is_wanted());
  requests_.apply();
  EXPECT_EQ(ask(), 0);
}

TEST_F(AskedPieces, OfOneFragmentAreAskedOnceForAllItsKerfs) {
  cut({0});
  cut({1}, 1);
  requests_.watch(leaving);
  EXPECT_EQ(ask(), 1) << "that opened last";
  requests_.apply();
  EXPECT_EQ(ask(), -1);
}

TEST_F(AskedPieces, OfACutAcrossTwoFragmentsAreAskedOfEach) {
  cut({0, 2});
  requests_.watch(leaving);
  EXPECT_EQ(ask(), 0);
  EXPECT_TRUE(requests_.is_wanted());
  EXPECT_TRUE(requests_.has_opened()) << "whoever asks for a hinge waits";
  requests_.apply();
  EXPECT_EQ(ask(), 2);
  requests_.apply();
  EXPECT_FALSE(requests_.is_wanted());
}

}  // namespace
}  // namespace hallux::simulator
