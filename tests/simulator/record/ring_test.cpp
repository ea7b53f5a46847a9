#include "simulator/record/ring.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <thread>

namespace hallux::simulator {
namespace {

TEST(Ring, GivesBackInOrder) {
  Ring<int> ring{3};
  EXPECT_TRUE(ring.push(1));
  EXPECT_TRUE(ring.push(2));
  int value = 0;
  EXPECT_TRUE(ring.pop(value));
  EXPECT_EQ(value, 1);
  EXPECT_TRUE(ring.pop(value));
  EXPECT_EQ(value, 2);
}

TEST(Ring, RefusesWhenFullAndWhenEmpty) {
  Ring<int> ring{2};
  int value = 7;
  EXPECT_FALSE(ring.pop(value));
  EXPECT_EQ(value, 7);
  EXPECT_TRUE(ring.push(1));
  EXPECT_TRUE(ring.push(2));
  EXPECT_FALSE(ring.push(3));
  EXPECT_EQ(ring.size(), 2U);
  EXPECT_TRUE(ring.pop(value));
  EXPECT_TRUE(ring.push(3));
  EXPECT_EQ(ring.size(), ring.capacity());
}

TEST(Ring, GoesRoundManyTimes) {
  Ring<int> ring{5};
  int value = 0;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(ring.push(i));
    if (i < 3) continue;
    ASSERT_TRUE(ring.pop(value));
    ASSERT_EQ(value, i - 3);
  }
  EXPECT_EQ(ring.size(), 3U);
}

TEST(Ring, LosesAndDoublesNothingBetweenTwoThreads) {
  constexpr std::uint64_t count = 50000;
  Ring<std::uint64_t> ring{64};
  std::jthread producer{[&ring] {
    for (std::uint64_t i = 0; i < count; ++i) {
      while (!ring.push(i)) std::this_thread::yield();
    }
  }};
  for (std::uint64_t expected = 0; expected < count; ++expected) {
    std::uint64_t value = 0;
    while (!ring.pop(value)) std::this_thread::yield();
    ASSERT_EQ(value, expected);
  }
}

}  // namespace
}  // namespace hallux::simulator
